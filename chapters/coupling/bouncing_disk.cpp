/// bouncing_disk: a disk of particles falls on a plate of finite elements and bounces, in one implicit system (monolithic.hpp); nothing
/// searches for contact. bouncing_disk_contact is the explicit way beside it.
///   ./bouncing_disk --cells 32 --around 100 --layers 8
///   ./bouncing_disk --cells 32,64 --soft-few 1e-5 --t-end 6
#include "chapters/coupling/bounce_panels.hpp"
#include "chapters/coupling/coupled.hpp"
#include "chapters/coupling/monolithic.hpp"
#include "chapters/scenes/bouncing_on_fem.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "bouncing_disk";
constexpr const char* purpose = "an elastic disk bounces on an elastic plate of finite elements by implicit MPM with Q9 elements";

/// Table 3: C_c and the step near the plate. Coarser and finer grids than its own take those of the nearest.
struct Near {
    double C_c, dt;
};
Near table_3(int cells, bool hard) {
    const int J = std::clamp(BouncingOnFem::refinement(cells), 2, 4);
    const double C_c = J == 2 ? (hard ? 0.06 : 0) : J == 3 ? 0.1 : 0.2;
    return {C_c, (hard ? 0.0005 : 0.001) / (1 << (J - 2))};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    BouncingOnFem disk;
    Common common;
    ImplicitOptions method;
    double near = 0;
    common.cells = {32};
    common.shape = QuadraticElement::name;
    common.dt_from = "step";
    common.cfl = 1;
    common.records = 2000;
    method.beta = 0.3;
    method.soft_few = 1e-2;
    disk.declare(options);
    options.number("near", near, "time", at_least(0), "time step near the plate; 0: that of the source's Table 3");
    method.declare(options, true);
    SceneTraits traits = traits_of(disk);
    traits.limit = "--near";
    common.declare(options, {QuadraticElement::name}, 1.7, traits);
    common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    for (const char* name : {"ppc", "dt", "dt-from"})
        if (options.given(name))
            throw BadInput(std::string("--") + name + ": --around and --layers tell the particles, --far and --near the steps");
    if (!options.given("soft-some")) method.soft_some = 1e-4 * method.soft_few;  // (57), (58)
    ImplicitSettings settings = coupled_settings(method, options, common.threads);
    const bool hard = method.soft_few >= 3e-4;  // nearer to (57) than to (58)
    const Description about{program, purpose, disk.name, disk.solves, {disk.columns.begin(), disk.columns.end()}, 0, bounce_panels()};
    return run_program(about, options, common, [&](int cells) {
        const Near table = table_3(cells, hard);
        BouncingOnFem one = disk;
        one.near = near > 0 ? near : table.dt, one.zone = one.layer(cells);
        if (!options.given("receding")) settings.receding.C_c = table.C_c;
        settings.receding.row = one.plate_rows(cells);
        Assembled a = assemble_implicit<QuadraticElement, FemBody>(one, settings, cells, common,
                                                                   newton_path(program, options, common, cells, method));
        a.critical_dt = std::min(one.near, one.far);
        return a;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
