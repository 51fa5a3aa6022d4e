/// two_disks_contact: two elastic disks meet and rebound (review 6.1.2) with fields of their own and contact on the grid (bardenhagen.hpp),
/// beside the contact that one shared field makes, which sticks and begins a cell too early. The error `touch` is a length.
///   ./two_disks_contact --contact frictionless --cells 20,40
///   ./two_disks_contact --field shared --plot png
#include "chapters/contact/bardenhagen.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/scenes/disks_in_contact.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "two_disks_contact";
constexpr const char* purpose = "two elastic disks meet and rebound by contact on the grid";

std::vector<Panel> panels() {
    return {{"",
             "t",
             "time t [time]",
             "distance of the faces [length]",
             {{"gap", "centres less two radii", "lines dt solid lc rgb '#c03030'"}},
             ""},
            {"",
             "t",
             "time t [time]",
             "speed of the lower disk [length/time]",
             {{"speed", "along the diagonal", "lines dt solid lc rgb '#3060c0'"}},
             ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    DisksInContact disks;
    ContactChoice contact;
    Common common;
    common.cells = {20};
    common.ppc = 3;
    common.records = 700;
    disks.DiskSettings::law = "neo-hookean";
    disks.declare(options);
    contact.declare(options);
    common.declare(options, {Hat::name}, 3.5, traits_of(disks));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    disks.t_end = common.t_end;
    using Scene = DisksInContact;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels()};
    return run_program(about, options, common, [&](int cells) {
        Scene scene = disks;
        scene.log = std::make_shared<ContactLog<2>>();
        return assemble_with<Hat, false>(Musl{}, scene, Flip{}, cells, common, Bardenhagen<2>(contact, {}, scene.log));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
