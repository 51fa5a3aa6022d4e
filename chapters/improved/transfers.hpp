/// The transfers by name, for `--transfer`, `--alpha` and `--order`. A new one is a header and an entry here.
#pragma once
#include <string>
#include <vector>

#include "chapters/explicit/flip.hpp"
#include "chapters/improved/affine.hpp"
#include "chapters/improved/consistent.hpp"
#include "chapters/improved/fmpm.hpp"
#include "lab/options.hpp"

namespace mpm {

/// What the command line says of the transfer.
struct TransferChoice {
    std::string name = "flip";
    double alpha = 1;
    int order = 2;

    void declare(Options& o) {
        o.choice("transfer", name, {"flip", "apic", "xpic", "fmpm", "consistent"}, "how velocities go between particles and grid");
        o.number("alpha", alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0); for --transfer flip and consistent");
        o.integer("order", order, "-", between(1, 1000), "terms of the series; for --transfer xpic and fmpm");
    }

    /// Refuses what means nothing or cannot work. Throws BadInput.
    void check(int ppc) const {
        const bool series = name == "xpic" || name == "fmpm", mix = name == "flip" || name == "consistent";
        if (order != 2 && !series) throw BadInput("--order: only --transfer xpic and fmpm have terms of a series, not " + name);
        if (alpha != 1 && !mix) throw BadInput("--alpha: only --transfer flip and consistent mix FLIP and PIC, not " + name);
        if (name == "consistent" && ppc < 2)
            throw BadInput(
                "--transfer consistent with --ppc 1: the mass matrix is singular with one particle per cell; allowed with --ppc 2 and "
                "more");
    }

    /// Calls visit(transfer) for the chosen one.
    template <bool TotalLagrangian, class Visit> void with(Visit&& visit) const {
        if (name == "apic")
            visit(Apic<TotalLagrangian>{});
        else if (name == "xpic")
            visit(xpic(order));
        else if (name == "fmpm")
            visit(Fmpm{order});
        else if (name == "consistent")
            visit(consistent<TotalLagrangian>());
        else
            visit(Flip{alpha});
    }

private:
    template <bool TotalLagrangian> Consistent<TotalLagrangian> consistent() const {
        Consistent<TotalLagrangian> c;
        c.alpha = alpha;
        return c;
    }
};

}  // namespace mpm
