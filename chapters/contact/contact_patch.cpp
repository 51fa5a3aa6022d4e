/// contact_patch: a block of two bodies, bonded by contact on the grid (bardenhagen.hpp; review 5.1), moves as the whole block does.
///   ./contact_patch --out two && ./contact_patch --whole --out one    # the same history
///   ./contact_patch --contact coulomb --mu 0.1                        # slides
#include "chapters/contact/bardenhagen.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/scenes/contact_patch.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "contact_patch";
constexpr const char* purpose = "two bonded blocks and one";

int run(int argc, char** argv) {
    Options options(program, purpose);
    ContactPatch patch;
    ContactChoice contact;
    contact.contact = "bonded";
    Common common;
    common.cells = {10};
    common.ppc = 2;
    common.records = 200;
    patch.declare(options);
    contact.declare(options);
    common.declare(options, {Hat::name}, 0.2, traits_of(patch));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    using Scene = ContactPatch;
    const Panel sway{"",
                     "t",
                     "time t [time]",
                     "mean displacement [length]",
                     {{"x_upper", "upper part, x", "lines dt solid lc rgb '#c03030'"},
                      {"x_lower", "lower part, x", "lines dt 2 lc rgb '#3060c0'"}},
                     ""};
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, {sway}};
    return run_program(about, options, common, [&](int cells) {
        Scene scene = patch;
        scene.hold_foot(cells);
        return assemble_with<Hat, false>(Musl{}, scene, Flip{}, cells, common, Bardenhagen<2>(contact));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
