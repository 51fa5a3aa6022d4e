/// impm_disks: two elastic disks meet and rebound (review 6.1.2) by the improved MPM (impm.hpp). One velocity field for both: they feel
/// each other as soon as a fit sees particles of both.
///   ./impm_disks --cells 40,80
/// With one point per cell (--quadrature centre) hourglass motion gains energy from the impact (notes.md), and so do 20 cells with four.
#include "chapters/improved/impm_assemble.hpp"
#include "chapters/scenes/two_disks.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "impm_disks";
constexpr const char* purpose = "two elastic disks meet and rebound by the improved MPM";

int run(int argc, char** argv) {
    Options options(program, purpose);
    TwoDisks<false> disks;
    Common common;
    ImpmOptions impm;
    double alpha = 1;
    common.cells = {40};
    common.ppc = 2;
    impm.quadrature = "gauss";
    disks.declare(options);
    impm.declare(options, 2);
    options.number("alpha", alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0)");
    common.declare(options, {Hat::name}, disks.t_end, traits_of(disks));
    common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    disks.t_end = common.t_end;
    const std::vector<Curve> curves{{"approach", "computed", "lines dt solid lc rgb '#c03030'"},
                                    {"approach_exact", "until they touch", "lines dt 2 lc rgb 'black'"}};
    const Description about{program, purpose, disks.name, disks.solves, {disks.columns.begin(), disks.columns.end()}, 0,
                            {{"", "t", "time t [time]", "distance of centres [length]", curves, ""}}};
    return run_program(about, options, common, [&](int cells) { return assemble_impm(impm.choice(), disks, alpha, cells, common); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
