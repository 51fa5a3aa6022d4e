/// cpdi_r4_column: a compliant column in strong gravity (review 3.6, figure 25) by CPDI-R4 (r4.hpp): domains are parallelograms that F
/// carries along.
///   ./cpdi_r4_column --g 1000 --plot png
#include "chapters/cpdi/column_program.hpp"

int main(int argc, char** argv) { return mpm::column_program<mpm::DomainR4>("cpdi_r4_column", mpm::rectangles_in, argc, argv); }
