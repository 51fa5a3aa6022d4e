/// The common part of the bar programs: a scheme, the bar, the weighting functions that suit it.
#pragma once
#include <functional>

#include "chapters/improved/variants.hpp"
#include "chapters/scenes/bar.hpp"

namespace mpm {

/// Runs `scheme` on the bar. `Shapes` are the weighting functions it accepts; `declare` adds the scheme's own options.
template <class Shapes, bool TotalLagrangian, class Scheme>
int bar_program(const std::string& program, const std::string& purpose, Scheme& scheme, int argc, char** argv,
                const std::function<void(Options&)>& declare = {}) {
    return guarded(program, [&] {
        Options options(program, purpose);
        Bar<TotalLagrangian> bar;
        Common common;
        TransferChoice choice;
        bar.declare(options);
        choice.declare(options);
        common.declare(options, Shapes::names(), bar.default_t_end(), traits_of(bar));
        if (declare) declare(options);
        options.parse(argc, argv);
        if (answered(options, program)) return 0;
        choice.check(common.ppc);
        const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, bar.period()};
        const Common chosen = common.with_period(bar.period());
        return run_program(about, options, chosen,
                           [&](int cells) { return assemble_named<Shapes, TotalLagrangian>(scheme, bar, choice, cells, chosen); });
    });
}

}  // namespace mpm
