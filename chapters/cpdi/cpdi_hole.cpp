/// cpdi_hole: a small particle falls through a wide one (review 3.7, figures 31 and 32) with CPDI-R4 (r4.hpp), unless the wide one is
/// split (split.hpp).
///   ./cpdi_hole --watch warn --plot png
///   ./cpdi_hole --split --plot png
#include <memory>

#include "chapters/cpdi/split.hpp"
#include "chapters/cpdi/tessellated.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/scenes/hole.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "cpdi_hole";
constexpr const char* purpose = "a hole in CPDI: a small particle falls through a wide one";

Assembled split_hole(const Hole& hole, int cells, const Common& common) {
    Hole scene = hole;
    scene.domains = std::make_shared<const std::vector<PolygonCells>>(scene.tessellate(DomainR4::name, cells, common.ppc));
    const auto make = [&](const auto& lattice, auto& points) {
        return SplittingParallelograms(lattice, points, rectangles_of<false>(lattice, points, (*scene.domains)[0]).half());
    };
    return assemble<SplittingParallelograms>(Musl{}, scene, Flip{}, ShapeFacts{DomainR4::name, 1, 2}, cells, common, make);
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Hole hole;
    Common common;
    bool split = false;
    common.cells = {7};
    common.shape = DomainR4::name;
    common.records = 200;
    options.flag("split", split, "particles whose domains span more than three cells are split (review 5.6.2)");
    hole.declare(options);
    common.declare(options, {DomainR4::name}, 4, traits_of(hole));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const Panel heights{"",
                        "t",
                        "time t [time]",
                        "height y [length]",
                        {{"y_small", "small particle", "lines dt solid lc rgb '#c03030'"},
                         {"y_wide", "wide particle", "lines dt 2 lc rgb '#3060c0'"}},
                        ""};
    const Description about{program, purpose, hole.name, hole.solves, {hole.columns.begin(), hole.columns.end()}, 0, {heights}};
    return run_program(about, options, common, [&](int cells) {
        return split ? split_hole(hole, cells, common) : assemble_domain<DomainR4, false>(Musl{}, hole, Flip{}, cells, common);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
