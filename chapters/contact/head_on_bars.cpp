/// head_on_bars: two elastic bars meet head on by contact on the grid (bardenhagen.hpp; review 5.1), against the exact waves.
///   ./head_on_bars --cells 50,100,200
///   ./head_on_bars --gap velocity --plot png    # feels the other bar a cell too early
#include "chapters/contact/bardenhagen.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/usf.hpp"
#include "chapters/scenes/head_on_bars.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "head_on_bars";
constexpr const char* purpose = "two elastic bars meet head on";

int run(int argc, char** argv) {
    Options options(program, purpose);
    BarsSettings bars;
    ContactChoice contact;
    Common common;
    std::string scheme = "musl";
    common.cells = {50, 100, 200};
    common.ppc = 2;
    common.cfl = 0.2;
    options.choice("scheme", scheme, {"usf", "musl"}, "method");
    bars.declare(options);
    contact.declare(options);
    common.declare(options, {Hat::name}, 0.4, traits_of(HeadOnBars({}, 0)));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const Panel velocity{"",
                         "t",
                         "time t [time]",
                         "mean velocity of the left bar [length/time]",
                         {{"v_left", "computed", "lines dt solid lc rgb '#c03030'"},
                          {"v_left_exact", "exact", "lines dt 2 lc rgb 'black'"}},
                         ""};
    using Scene = HeadOnBars;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, {velocity}};
    return run_program(about, options, common, [&](int cells) {
        const Scene scene(bars, common.t_end);
        const Bardenhagen<1> coupling(contact, {}, scene.log);
        return scheme == "usf" ? assemble_with<Hat, false>(Usf{}, scene, Flip{}, cells, common, coupling)
                               : assemble_with<Hat, false>(Musl{}, scene, Flip{}, cells, common, coupling);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
