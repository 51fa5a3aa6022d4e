/// cpdi_q4_column: a compliant column in strong gravity (review 3.6, figure 25) by CPDI-Q4 (q4.hpp): domains are quadrilaterals that share
/// their corners.
///   ./cpdi_q4_column --g 1000 --plot png
#include "chapters/cpdi/column_program.hpp"

int main(int argc, char** argv) { return mpm::column_program<mpm::DomainQ4>("cpdi_q4_column", mpm::rectangles_in, argc, argv); }
