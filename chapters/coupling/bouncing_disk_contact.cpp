/// bouncing_disk_contact: the disk of bouncing_disk on a plate of particles, by explicit USF and contact on the grid (bardenhagen.hpp):
/// what the monolithic coupling does without.
///   ./bouncing_disk_contact --cells 32,64
#include "chapters/contact/bardenhagen.hpp"
#include "chapters/coupling/bounce_panels.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/usf.hpp"
#include "chapters/scenes/bouncing_on_particles.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "bouncing_disk_contact";
constexpr const char* purpose = "an elastic disk bounces on an elastic plate of particles by explicit MPM and contact on the grid";

int run(int argc, char** argv) {
    Options options(program, purpose);
    BouncingOnParticles disk;
    ContactChoice contact;
    Common common;
    common.cells = {32};
    common.ppc = 4;
    common.cfl = 0.5;
    common.records = 2000;
    disk.declare(options);
    contact.declare(options);
    common.declare(options, {Hat::name}, 1.7, traits_of(disk));
    common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const Description about{program, purpose, disk.name, disk.solves, {disk.columns.begin(), disk.columns.end()}, 0, bounce_panels()};
    return run_program(about, options, common, [&](int cells) {
        BouncingOnParticles one = disk;
        one.refinement(cells);
        one.start(cells);
        return assemble_with<Hat, false>(Usf{}, one, Flip{}, cells, common, Bardenhagen<2>(contact, {}, one.log));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
