/// fem_bar: axial vibration of a bar (review 6.1.1) by explicit finite elements, total- (total.hpp) or updated-Lagrangian (updated.hpp).
///   ./fem_bar --mode 10 --formulation updated --gauss 1
#include "chapters/fem/total.hpp"
#include "chapters/fem/updated.hpp"
#include "chapters/scenes/bar.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "fem_bar";
constexpr const char* purpose = "axial vibration of a bar by explicit finite elements";
using Scene = Bar<true>;  // both formulations start from a mesh of the bar as it is at rest

template <class Scheme> Assembled elements(const Scheme& scheme, const Scene& bar, const Common& common, int cells) {
    Assembled a;
    ElementShapes::with(common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), true>(scheme, bar, NoTransfer{}, cells, common);
    });
    return a;
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Scene bar;
    Common common;
    std::string formulation = "total";
    int gauss = 2;
    bar.placing = "gauss";
    common.ppc = gauss;
    bar.declare(options);
    options.choice("formulation", formulation, {"total", "updated"},
                   "configuration of gradients and stresses: the initial one or the moved mesh");
    options.integer("gauss", gauss, "-", between(1, 3), "Gauss points per element; masses are lumped by their row sums");
    common.declare(options, ElementShapes::names(), bar.default_t_end(), traits_of(bar));
    options.contradict("gauss", "ppc");
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    Common chosen = common.with_period(bar.period());
    if (options.given("gauss")) chosen.ppc = gauss;
    if (chosen.shape == Lagrange2::name && chosen.ppc < 2)
        throw BadInput("--gauss 1: one point leaves the end nodes of quadratic elements (--shape lagrange) without mass; allowed 2 and 3");
    const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
    return run_program(about, options, chosen, [&](int cells) {
        return formulation == "total" ? elements(TotalFem{}, bar, chosen, cells) : elements(UpdatedFem{}, bar, chosen, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
