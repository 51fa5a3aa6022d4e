/// implicit_cantilever: a short beam swings for eight seconds by implicit MPM (Aulisa and Capodaglio, 6.2, figures 7 and 8); --cells 8, 16,
/// 32 are its J = 2, 3, 4.
///   ./implicit_cantilever --cells 8
///   ./implicit_cantilever --cells 16 --carry conserving
#include <algorithm>

#include "chapters/implicit/program.hpp"
#include "chapters/scenes/cantilever.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "implicit_cantilever";
constexpr const char* purpose = "a short beam swings by implicit MPM with Q9 elements";

std::vector<Panel> panels() {
    return {{"", "t", "time t [s]", "displacement of the tip [m]", {{"tip", "computed", "lines dt solid lc rgb '#c03030'"}}, ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Cantilever beam;
    Common common;
    ImplicitOptions method;
    common.cells = {8};
    common.dt = 0.008;
    common.records = 1000;
    declare_plane(options, beam, method, common, 8);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (!options.given("soft-few")) method.soft_few = 1e-6 / std::max(1.0, beam.contrast);  // (53), of the inner part's E
    settle_plane(options, method, common, "--rows and --layers");
    ImplicitSettings settings = method.settings(options, common.threads);
    settings.receding.axis = 0;
    const Description about{program, purpose, beam.name, beam.solves, {beam.columns.begin(), beam.columns.end()}, 0, panels()};
    return run_program(about, options, common, [&](int cells) {
        return assemble_implicit<QuadraticElement>(beam, settings, cells, common, newton_path(program, options, common, cells, method));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
