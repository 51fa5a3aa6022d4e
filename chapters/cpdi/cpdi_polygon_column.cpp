/// cpdi_polygon_column: a compliant column in strong gravity (review 3.6, figure 25) by CPDI with polygons (polygon.hpp): centroidal
/// Voronoi cells, as many as rectangles of the same size. It links CGAL.
///   ./cpdi_polygon_column --g 1000 --plot png
#include "chapters/cpdi/column_program.hpp"
#include "lab/voronoi.hpp"

int main(int argc, char** argv) {
    const auto cells = [](const mpm::Box& box, const mpm::CellCounts& counts) {
        const mpm::Polygon outline({box.low, {box.high[0], box.low[1]}, box.high, {box.low[0], box.high[1]}});
        return mpm::centroidal_voronoi(outline, counts.all()).cells;
    };
    return mpm::column_program<mpm::DomainPolygon>("cpdi_polygon_column", cells, argc, argv);
}
