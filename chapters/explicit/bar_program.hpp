/// The common part of the bar programs: a scheme, the bar, the weighting functions that suit it.
#pragma once
#include <functional>

#include "chapters/explicit/flip.hpp"
#include "chapters/scenes/bar.hpp"
#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/assemble.hpp"

namespace mpm {

/// Gives a kernel its initial particle size, where it has one.
template <class Kernel> Kernel sized(int ppc) {
    Kernel kernel{};
    if constexpr (requires { kernel.l = 1.0; }) kernel.l = 1.0 / ppc;
    if constexpr (requires { kernel.l0 = 1.0; }) kernel.l0 = 1.0 / ppc;
    return kernel;
}

/// Runs `scheme` on the bar. `Shapes` are the weighting functions it accepts; `declare` adds the scheme's own options.
template <class Shapes, bool TotalLagrangian, class Scheme>
int bar_program(const std::string& program, const std::string& purpose, Scheme& scheme, int argc, char** argv,
                const std::function<void(Options&)>& declare = {}) {
    return guarded(program, [&] {
        Options options(program, purpose);
        Bar<TotalLagrangian> bar;
        Common common;
        Flip flip;
        bar.declare(options);
        options.number("alpha", flip.alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0)");
        common.declare(options, Shapes::names(), bar.default_t_end());
        if (declare) declare(options);
        options.parse(argc, argv);
        if (answered(options, program)) return 0;
        const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
        if (common.periods > 0) common.t_end = common.periods * bar.period();
        return run_program(about, options, common, [&](int cells) {
            Assembled a;
            Shapes::with(common.shape, [&](auto kernel) {
                using Kernel = decltype(kernel);
                using Moving = Tensor<1, Kernel>;
                using Shape = std::conditional_t<TotalLagrangian, Stored<Moving>, Moving>;
                a = assemble<Shape>(scheme, bar, flip, cells, common, [&](const auto& lattice, const auto& points) {
                    const Moving moving{lattice, sized<Kernel>(common.ppc)};
                    if constexpr (TotalLagrangian) return Shape(moving, points);
                    else return moving;
                });
            });
            return a;
        });
    });
}

}  // namespace mpm
