/// dam_break: a column of water breaks down in a box (review 5.4.1, figures 53 and 54) by MUSL; by USL it fails, with and without cut-off.
///   ./dam_break --plot gif
///   ./dam_break --barrier 0.5 --plot gif
///   ./dam_break --length 1 --height 2 --cells 120 --t-end 0.9     # Martin and Moyce's column, n^2 = 2
#include "chapters/fluid/dam_break/settings.hpp"
#include "chapters/weighting/shapes.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "dam_break";
constexpr const char* purpose = "a column of water breaks down in a box";

void check(const DamBreakSettings& s) {
    s.dam.check();
    if (s.cutoff > 0 && s.scheme != "usl") throw BadInput("--cutoff: only --scheme usl leaves nodes out, not " + s.scheme);
    if (s.scheme == "usl" && s.common.shape != Hat::name)
        throw BadInput("--shape " + s.common.shape + ": allowed with --scheme usl: hat");
}

std::vector<Panel> panels() {
    return {{"", "T", "T = t (g h0)^{1/2}/l0 [-]", "front Z = x/l0 [-]",
             {{"Z", "computed", "lines dt solid lc rgb '#c03030'"},
              {"Z_shallow", "shallow water, 1 + 2 T", "lines dt 2 lc rgb 'black'"}}, ""},
            {"", "t", "time t [s]", "volume ratio J [-]",
             {{"J_05", "5 % of the particles are below", "lines dt solid lc rgb '#3060c0'"},
              {"J_95", "5 % are above", "lines dt 2 lc rgb '#c03030'"}}, ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    DamBreakSettings s;
    s.common.cells = {70};
    s.common.ppc = 2;
    s.common.cfl = 0.14;  // half the review's dt = 0.1 h/sqrt(kappa/rho), with which the energy of 1.7 s grows by 5 % (notes.md)
    s.common.records = 400;
    options.choice("scheme", s.scheme, {"musl", "usl"}, "method");
    options.number("cutoff", s.cutoff, "mass", at_least(0), "nodes with at most this mass are left out (2.63); for --scheme usl");
    options.number("alpha", s.alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0)");
    s.dam.declare(options);
    s.common.declare(options, {Hat::name, Ugimp::name, Cubic::name}, 1.7, traits_of(DamBreak{}));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    check(s);
    const Description about{
        program, purpose, DamBreak::name, DamBreak::solves, {DamBreak::columns.begin(), DamBreak::columns.end()}, 0, panels()};
    return run_program(about, options, s.common, [&](int cells) { return s.scheme == "usl" ? usl_dam(s, cells) : musl_dam(s, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
