/// impm_bar: axial vibration of a bar (review 6.1.1) by the improved MPM (impm.hpp).
///   ./impm_bar --cells 16 --ppc 2
#include "chapters/improved/impm_assemble.hpp"
#include "chapters/scenes/bar.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "impm_bar";
constexpr const char* purpose = "axial vibration of a bar by the improved MPM";

int run(int argc, char** argv) {
    Options options(program, purpose);
    Bar<false> bar;
    Common common;
    ImpmOptions impm;
    double alpha = 1;
    common.ppc = 2;
    bar.declare(options);
    impm.declare(options, 1);
    options.number("alpha", alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0)");
    common.declare(options, {Hat::name}, bar.default_t_end(), traits_of(bar));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    common = common.with_period(bar.period());
    const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
    return run_program(about, options, common, [&](int cells) { return assemble_impm(impm.choice(), bar, alpha, cells, common); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
