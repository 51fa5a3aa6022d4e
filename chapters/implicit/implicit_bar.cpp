/// implicit_bar: axial vibration of a bar (review 6.1.1) by implicit MPM with steps from a part of the explicit limit to thousands of it,
/// against the closed form of Newmark's rule.
///   ./implicit_bar --mode 10 --cfl 10
#include "chapters/implicit/bar_scene.hpp"
#include "chapters/implicit/program.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "implicit_bar";
constexpr const char* purpose = "axial vibration of a bar by implicit MPM, against the closed form of Newmark's rule";

int run(int argc, char** argv) {
    Options options(program, purpose);
    ImplicitBar bar;
    Common common;
    ImplicitOptions method;
    common.cfl = 1;
    bar.declare(options);
    method.declare(options, false);
    common.declare(options, {LinearElement::name}, bar.default_t_end(), traits_of(bar));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const Common chosen = common.with_period(bar.period());
    const ImplicitSettings settings = method.settings(options, 1);
    if (chosen.dt_from == "step") throw BadInput("--dt-from step: the closed form is that of equal steps");
    const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
    return run_program(about, options, chosen, [&](int cells) {
        ImplicitBar one = bar;
        one.cells = cells, one.ppc = chosen.ppc, one.newmark = settings.newmark;
        const double limit = one.cell_size(cells) / (one.wave_speed() + one.speed());
        one.dt = whole_steps(chosen.t_end, chosen.dt > 0 ? chosen.dt : chosen.cfl * limit, limit).dt;
        return assemble_implicit<LinearElement>(one, settings, cells, chosen, newton_path(about.program, options, chosen, cells, method));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
