/// cpdi_two_disks: the two elastic disks of review 6.1.2 with particle domains of four kinds (review 3.6). The contact comes
/// free with the one velocity field.
///   ./cpdi_two_disks --shape cpdi-t3 --cells 20 --plot gif
///   ./cpdi_two_disks --shape cpdi-q4 --cells 40
#include "chapters/cpdi/disks_of_domains.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "lab/mesh.hpp"
#include "lab/program.hpp"
#include "lab/traits.hpp"
#include "lab/voronoi.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "cpdi_two_disks";
constexpr const char* purpose = "two elastic disks meet and rebound, by CPDI";

Triangles triangles(const Outline& outline, double size) { return refine(Polygon(outline), size); }
PolygonCells polygons(const Outline& outline, long count) { return centroidal_voronoi(Polygon(outline), count).cells; }

std::vector<Panel> panels() {
    return {{"",
             "t",
             "time t [time]",
             "distance of centres [length]",
             {{"approach", "computed", "lines dt solid lc rgb '#c03030'"},
              {"approach_exact", "until they touch", "lines dt 2 lc rgb 'black'"}},
             ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    DiskSettings disks;
    Common common;
    common.cells = {20};
    common.ppc = 2;
    common.shape = DomainR4::name;
    disks.declare(options);
    common.declare(options, domain_names(), 3.5, traits_of(TwoDisks<false>{}));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    DisksOfDomains scene(disks, common.t_end);
    scene.triangles = triangles;
    scene.polygons = polygons;
    using Scene = DisksOfDomains;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels()};
    return run_program(about, options, common, [&](int cells) { return assemble_domains<false>(Musl{}, scene, Flip{}, cells, common); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
