/// implicit_contrast_bar: the bar of contrast_bar, whose outer half is up to 1e8 times stiffer, by implicit MPM: its steps follow the
/// vibration, not the fastest wave.
///   ./implicit_contrast_bar --contrast 1e8 --cells 16,32,64
#include "chapters/implicit/program.hpp"
#include "chapters/scenes/contrast_bar.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "implicit_contrast_bar";
constexpr const char* purpose = "vibration of a bar whose halves differ in stiffness by implicit MPM";

struct Scene : ContrastBar<false> {
    using Law = Materials<NeoHookean>;
    Law law() const { return {{{0, E / 2, rho}, {0, contrast * E / 2, rho}}}; }
    double wave_speed() const { return law().wave_speed(); }
    std::array<Lines, 1> lines(int cells) const {
        const Lattice<1> where = lattice(cells, 1);
        return {even_lines(0, where.upper()[0], where.cells(0))};
    }
    std::vector<char> held(const Rectilinear<1>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()), 0);
        all[0] = 1;
        return all;
    }
    Vec<1> body_force(double) const { return Vec<1>(0); }
    using Observer = WaveObserver<Scene>;
};

int run(int argc, char** argv) {
    Options options(program, purpose);
    Scene bar;
    Common common;
    ImplicitOptions method;
    double per_period = 200;
    common.cells = {32};
    bar.v0 = 1e-4;
    bar.declare(options);
    method.declare(options, false);
    options.number("steps", per_period, "-", above(2), "steps in a period, unless --dt or --cfl is given");
    common.cfl = 1;
    common.declare(options, {LinearElement::name}, bar.period(), {.period = true});
    options.contradict("cfl", "steps");
    options.contradict("dt", "steps");
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (common.periods == 0 && !options.given("t-end")) common.t_end = bar.period();  // one period of this bar
    if (!options.given("cfl") && !options.given("dt")) common.dt = bar.period() / per_period;
    const ImplicitSettings settings = method.settings(options, 1);
    const Common chosen = common.with_period(bar.period());
    const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
    return run_program(about, options, chosen, [&](int cells) {
        return assemble_implicit<LinearElement>(bar, settings, cells, chosen, newton_path(program, options, chosen, cells, method));
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
