/// cpdi_t3_column: a compliant column in strong gravity (review 3.6, figure 25) by CPDI-T3 (t3.hpp): two triangles in the place of a
/// rectangle.
///   ./cpdi_t3_column --g 1000 --plot png
#include "chapters/cpdi/column_program.hpp"

int main(int argc, char** argv) {
    const auto triangles = [](const mpm::Box& box, const mpm::CellCounts& counts) {
        return mpm::polygons_of_mesh(mpm::triangles_of(box, counts, mpm::Diagonals::alternating));
    };
    return mpm::column_program<mpm::DomainT3>("cpdi_t3_column", triangles, argc, argv);
}
