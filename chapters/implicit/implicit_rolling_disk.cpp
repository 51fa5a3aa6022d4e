/// implicit_rolling_disk: an elastic disk rolls down an incline by implicit MPM (Aulisa and Capodaglio, 6.2, Table 1); --cells 40, 80, 160,
/// 320 are its J = 1 to 4.
///   ./implicit_rolling_disk --cells 40,80
///   ./implicit_rolling_disk --E 4.2e8 --receding 0
#include "chapters/implicit/program.hpp"
#include "chapters/scenes/rolling_disk.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "implicit_rolling_disk";
constexpr const char* purpose = "an elastic disk rolls down an incline by implicit MPM with Q9 elements";

int run(int argc, char** argv) {
    Options options(program, purpose);
    RollingDisk disk;
    Common common;
    ImplicitOptions method;
    common.cells = {40};
    common.dt = 0.01;
    common.records = 250;
    method.receding = 0.5;
    declare_plane(options, disk, method, common, 2.5);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (!options.given("gap") && disk.E > 4.2e7) disk.gap = 0.3;
    if (!options.given("soft-few")) method.soft_few = std::min(1.0, 4200 / disk.E);  // (50), (51): E C_E is the same
    settle_plane(options, method, common, "--around and --layers");
    const ImplicitSettings settings = method.settings(options, common.threads);
    const Description about{program, purpose, disk.name, disk.solves, {disk.columns.begin(), disk.columns.end()}, 0, {disk.path_panel()}};
    return run_program(about, options, common, [&](int cells) {
        return assemble_implicit<QuadraticElement>(disk, settings, cells, common, newton_path(program, options, common, cells, method));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
