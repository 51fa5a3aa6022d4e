/// cpdi_cylinder: a thick cylinder under inner pressure (review 3.6, 4.2.3) by CPDI with quadrilaterals, triangles or polygons, loaded on
/// their edges; at rest it has Lame's stresses. USL: forces over nodal masses are bounded, both go through the corners.
///   ./cpdi_cylinder --shape cpdi-q4 --cells 20,40,80
///   ./cpdi_cylinder --shape cpdi-polygon --cells 40 --frames 1
#include "chapters/cpdi/cylinder.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/usl.hpp"
#include "lab/program.hpp"
#include "lab/traits.hpp"
#include "lab/voronoi.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "cpdi_cylinder";
constexpr const char* purpose = "a thick cylinder under inner pressure by CPDI";

/// Centroidal Voronoi cells within the polar mesh's outline, as many as it has quadrilaterals.
PolygonCells voronoi_cells(const Quadrilaterals& polar, const CellCounts& n) {
    const int row = n.first + 1;
    Outline outline;
    const auto add = [&](int point) { outline.push_back(polar.points[static_cast<std::size_t>(point)]); };
    for (int j = 0; j <= n.second; ++j) add(j * row + n.first);
    for (int j = n.second; j >= 0; --j) add(j * row);
    PolygonCells mesh = centroidal_voronoi(Polygon(outline), n.all()).cells;
    for (Vec<2>& x : mesh.points) x = (x.array().abs() < 1e-12 * polar.points.back().norm()).select(0, x);  // on the planes of symmetry
    return mesh;
}

std::vector<Panel> panels() {
    return {{"",
             "t",
             "time t [time]",
             "mean radial displacement [length]",
             {{"u_mean", "computed", "lines dt solid lc rgb '#c03030'"}, {"u_mean_exact", "Lame", "lines dt 2 lc rgb 'black'"}},
             ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    CylinderCase cylinder;
    Common common;
    common.cells = {20};
    common.ppc = 2;
    common.cfl = 0.5;
    common.shape = DomainQ4::name;
    common.records = 100;
    cylinder.declare(options);
    const std::vector<std::string> shapes{DomainQ4::name, DomainT3::name, DomainPolygon::name};
    common.declare(options, shapes, cylinder.time_to_rest(), traits_of(PressedCylinder(cylinder)));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    cylinder.check();
    if (!options.given("t-end")) common.t_end = cylinder.time_to_rest();
    PressedCylinder scene(cylinder);
    scene.polygons = voronoi_cells;
    using Scene = PressedCylinder;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels()};
    return run_program(about, options, common, [&](int cells) { return assemble_domains<false>(Usl{}, scene, Flip{}, cells, common); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
