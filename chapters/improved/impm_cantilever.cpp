/// impm_cantilever: a beam vibrates in its first bending mode, by the improved MPM (impm.hpp), beside Timoshenko's theory.
///   ./impm_cantilever --cells 32,64
/// With --quadrature centre nothing resists hourglass motion (notes.md).
#include "chapters/improved/impm_assemble.hpp"
#include "chapters/scenes/vibrating_beam.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "impm_cantilever";
constexpr const char* purpose = "a cantilever's first bending mode by the improved MPM";

int run(int argc, char** argv) {
    Options options(program, purpose);
    VibratingBeam beam;
    Common common;
    ImpmOptions impm;
    double alpha = 1;
    common.cells = {32};
    common.ppc = 2;
    common.cfl = 0.3;
    impm.quadrature = "gauss";
    beam.declare(options);
    impm.declare(options, 2);
    options.number("alpha", alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0)");
    common.declare(options, {Hat::name}, 2 * beam.period(), traits_of(beam));
    common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    beam.check();
    if (!options.given("t-end")) common.t_end = 2 * beam.period();  // of this beam, not of the default one
    common = common.with_period(beam.period());
    const std::vector<Curve> curves{{"tip", "computed", "lines dt solid lc rgb '#c03030'"},
                                    {"tip_exact", "Timoshenko beam", "lines dt 2 lc rgb 'black'"}};
    const Description about{program, purpose, beam.name, beam.solves, {beam.columns.begin(), beam.columns.end()}, beam.period(),
                            {{"", "t", "time t [time]", "displacement of the tip [length]", curves, ""}}};
    return run_program(about, options, common, [&](int cells) { return assemble_impm(impm.choice(), beam, alpha, cells, common); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
