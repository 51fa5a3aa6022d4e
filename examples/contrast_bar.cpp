/// contrast_bar: vibration of a bar whose halves differ in stiffness, up to 1e8 and more, by each scheme: the first of the stiff cases.
///   ./contrast_bar --scheme tlmpm --contrast 1e6 --cells 16,32,64
#include <algorithm>

#include "chapters/weighting/shapes.hpp"
#include "examples/contrast_bar/settings.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "contrast_bar";
constexpr const char* purpose = "vibration of a bar whose halves differ in stiffness";

int run(int argc, char** argv) {
    Options options(program, purpose);
    ContrastSettings s;
    s.common.cells = {32};
    options.choice("scheme", s.scheme, {"usl", "usf", "musl", "tlmpm", "impm", "cpdi"}, "method; cpdi: CPDI-L2 by USL");
    s.scene.declare(options);
    s.transfer.declare(options);
    s.common.declare(options, AllShapes::names(), s.scene.period(), {.period = true});
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    s.transfer.check(s.common.ppc);
    const std::vector<std::string> updated = UpdatedShapes::names();
    if (s.scheme != "tlmpm" && std::find(updated.begin(), updated.end(), s.common.shape) == updated.end())
        throw BadInput("--shape " + s.common.shape + ": allowed with --scheme tlmpm only, its particles never leave their cells");
    if (s.scheme == "impm" || s.scheme == "cpdi") {
        if (s.common.shape != Hat::name) throw BadInput("--shape " + s.common.shape + ": --scheme " + s.scheme + " has its own weighting");
        if (s.transfer.name != "flip") throw BadInput("--transfer " + s.transfer.name + ": allowed with --scheme " + s.scheme + ": flip");
    }
    if (s.scheme == "cpdi" && s.transfer.alpha != 1) throw BadInput("--alpha: --scheme cpdi has FLIP alone");
    const bool gimp = s.common.shape == Ugimp::name || s.common.shape == Cpgimp::name;
    if (gimp && s.scene.outer_ppc > 0 && s.scene.outer_ppc != s.common.ppc)
        throw BadInput("--outer-ppc with --shape " + s.common.shape + ": its particles are of one size");
    const auto& bar = s.scene;
    if (s.common.periods == 0 && !options.given("t-end")) s.common.t_end = bar.period();  // one period of this bar
    ContrastSettings chosen = s;
    chosen.common = s.common.with_period(bar.period());
    const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
    return run_program(about, options, chosen.common, [&](int cells) {
        if (s.scheme == "usl") return usl_contrast(chosen, cells);
        if (s.scheme == "usf") return usf_contrast(chosen, cells);
        if (s.scheme == "musl") return musl_contrast(chosen, cells);
        if (s.scheme == "impm") return impm_contrast(chosen, cells);
        if (s.scheme == "cpdi") return cpdi_contrast(chosen, cells);
        return tlmpm_contrast(chosen, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
