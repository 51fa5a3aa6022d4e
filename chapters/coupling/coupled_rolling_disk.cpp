/// coupled_rolling_disk: an elastic disk of particles rolls down an elastic plate of finite elements in one implicit system
/// (monolithic.hpp); nothing searches for contact.
///   ./coupled_rolling_disk --E 4.2e7 --cells 40,80 --around 150 --layers 11
#include "chapters/coupling/coupled.hpp"
#include "chapters/coupling/monolithic.hpp"
#include "chapters/scenes/rolling_on_plate.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "coupled_rolling_disk";
constexpr const char* purpose = "an elastic disk rolls down an elastic plate of finite elements by implicit MPM with Q9 elements";

std::vector<Panel> panels() {
    return {RollingDisk::path_panel(),
            {"", "t", "time t [s]", "force on the plate [N/m]", {{"pressing", "normal", "lines dt solid lc rgb '#3060c0'"}}, ""}};
}

/// Gap under the disk for E = 4.2e5, 4.2e6, 4.2e7.
double gap_for(double E) { return E < 1.33e6 ? 0.15 : E < 1.33e7 ? 0.2 : 0.25; }

int run(int argc, char** argv) {
    Options options(program, purpose);
    RollingOnPlate disk;
    Common common;
    ImplicitOptions method;
    common.cells = {40};
    common.dt = 0.01;
    common.records = 250;
    method.receding = 0.5;
    declare_plane(options, disk, method, common, 2.5);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (!options.given("E-plate")) disk.E_plate = 2 * disk.E;
    if (!options.given("gap")) disk.gap = gap_for(disk.E);
    if (!options.given("soft-few")) method.soft_few = std::min(1.0, 4200 / disk.E);  // (54) to (56): E C_E is the same
    settle_plane(options, method, common, "--around and --layers");
    ImplicitSettings settings = coupled_settings(method, options, common.threads);
    const Description about{program, purpose, disk.name, disk.solves, {disk.columns.begin(), disk.columns.end()}, 0, panels()};
    return run_program(about, options, common, [&](int cells) {
        settings.receding.row = disk.plate_rows(cells);
        return assemble_implicit<QuadraticElement, FemBody>(disk, settings, cells, common,
                                                            newton_path(program, options, common, cells, method));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
