/// steel_disk: a steel disk penetrates an aluminium target at 1160 m/s (review 6.1.3, figures 63 and 64), by each updated-Lagrangian
/// scheme. Steel is elastic, aluminium yields (von Mises, radial return); contact comes free with the one velocity field. SI units.
/// On one grid hat functions come nearest to the depth of fine ones, by MUSL or USF. USL needs --cutoff 1e-6; cpGIMP ends where a particle
/// has turned by 90 degrees (F11 <= 0).
///   ./steel_disk --plot gif
///   ./steel_disk --cells 25,50,100
#include "chapters/weighting/shapes.hpp"
#include "examples/steel_disk/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "steel_disk";
constexpr const char* purpose = "a steel disk penetrates an aluminium target";

void check(const SteelDiskSettings& s) {
    if (s.alpha != 1 && s.transfer != "flip") throw BadInput("--alpha: only --transfer flip mixes FLIP and PIC, not " + s.transfer);
    if (s.cutoff > 0 && s.scheme != "usl") throw BadInput("--cutoff: only --scheme usl leaves nodes out, not " + s.scheme);
}

std::vector<Panel> panels() {
    const Curve depth{"depth", "lowest steel below the first surface", "lines dt solid lc rgb '#c03030'"};
    return {{"", "t", "time t [s]", "depth [m]", {depth}, ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    SteelDiskSettings s;
    s.common.cells = {50};
    s.common.ppc = 2;
    s.common.cfl = 0.06171;  // dt = 1e-8 s on 50 cells
    options.choice("scheme", s.scheme, {"usl", "usf", "musl"}, "method");
    options.number("cutoff", s.cutoff, "mass", at_least(0), "nodes with at most this mass are left out (2.63); for --scheme usl");
    s.impact.declare(options);
    options.choice("transfer", s.transfer, {"flip", "apic"}, "how velocities go between particles and grid");
    options.number("alpha", s.alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0); for --transfer flip");
    s.common.declare(options, UpdatedShapes::names(), SteelDisk{}.t_end, traits_of(SteelDisk{}));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    check(s);
    const Description about{
        program, purpose, SteelDisk::name, SteelDisk::solves, {SteelDisk::columns.begin(), SteelDisk::columns.end()}, 0, panels()};
    return run_program(about, options, s.common, [&](int cells) {
        if (s.scheme == "usl") return usl_impact(s, cells);
        if (s.scheme == "usf") return usf_impact(s, cells);
        return musl_impact(s, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
