/// One run of the manufactured square or vortex without files: what mms_square and vortex do with one row.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/explicit/usf.hpp"
#include "chapters/explicit/usl.hpp"
#include "chapters/improved/fmpm.hpp"
#include "chapters/mms/square.hpp"
#include "chapters/mms/vortex.hpp"
#include "chapters/weighting/assemble_with.hpp"

namespace mpm::test {

struct PlaneRun {
    double e1, e2, kinetic, work, drift, momentum;  // work and drift in parts of the kinetic energy at the start
};

/// To t_end in equal steps of at most dt.
inline PlaneRun run_plane(const Assembled& a, double t_end, double wanted_dt) {
    const Simulation& s = a.simulation;
    const int steps = static_cast<int>(std::ceil(t_end / wanted_dt * (1 - 1e-12)));
    const double dt = t_end / steps;
    const Measures first = s.measure();
    Supply sum;
    s.sample(0, 0);
    for (int k = 0; k < steps; ++k) {
        s.step(k * dt, dt);
        const Supply supply = s.supply(k * dt, dt);
        sum.work += supply.work;
        for (const std::size_t d : {0, 1}) sum.impulse[d] += supply.impulse[d];
        s.sample((k + 1) * dt, 0);
    }
    const Measures last = s.measure();
    const auto errors = a.errors(t_end);
    const auto lost = [&](std::size_t d) { return last.momentum[d] - first.momentum[d] - sum.impulse[d]; };
    return {errors[0].value,         errors[1].value,
            first.kinetic,           sum.work / first.kinetic,
            (last.balance() - first.balance() - sum.work) / first.kinetic,
            std::hypot(lost(0), lost(1)) / first.momentum_in_play};
}

inline Common with_ppc(int ppc) {
    Common common;
    common.ppc = ppc;
    return common;
}

/// The square over one period with dt = 0.2 h/sqrt(E/rho), as the review has it, or a part of it.
template <class Kernel, class Scheme, class Transfer>
PlaneRun run_square(const SquareCase& square, const Scheme& scheme, const Transfer& transfer, int cells, int ppc = 2, double part = 1) {
    constexpr bool total = std::is_same_v<Scheme, Tlmpm>;
    const Assembled a = assemble_with<Kernel, total>(scheme, Square<total>(square), transfer, cells, with_ppc(ppc));
    return run_plane(a, part * square.period(), 0.2 / cells / std::sqrt(square.E / square.rho));
}

/// The vortex over T0 with dt = 0.1 h/sqrt(E/rho), or a part of it.
template <class Kernel, class Transfer>
PlaneRun run_vortex(const VortexCase& ring, const Transfer& transfer, int cells, int ppc = 2, double part = 1) {
    const Assembled a = assemble_with<Kernel, true>(Tlmpm{}, Vortex<true>(ring), transfer, cells, with_ppc(ppc));
    return run_plane(a, part * ring.T0, 0.1 * 2 * ring.R_o / cells / std::sqrt(ring.E / ring.rho));
}

}  // namespace mpm::test
