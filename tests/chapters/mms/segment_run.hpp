/// One run of the manufactured segment without files: what mms_segment does with one row.
#pragma once
#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/explicit/usf.hpp"
#include "chapters/explicit/usl.hpp"
#include "chapters/fem/total.hpp"
#include "chapters/fem/updated.hpp"
#include "examples/mms_segment/segment.hpp"

namespace mpm::test {

struct SegmentRun {
    double e1, e2, rmse, kinetic, work, drift, momentum;  // work and drift in parts of the kinetic energy at the start
};

template <class Scheme> constexpr bool is_fem = std::is_same_v<Scheme, TotalFem> || std::is_same_v<Scheme, UpdatedFem>;
template <class Scheme> constexpr bool total_lagrangian = is_fem<Scheme> || std::is_same_v<Scheme, Tlmpm>;
template <class Scheme> using SegmentTransfer = std::conditional_t<is_fem<Scheme>, NoTransfer, Flip>;

/// `part` of a period in steps of `courant` h/c, c = sqrt(E/rho), or near to it.
inline SegmentRun run_segment(const Assembled& a, const SegmentMotion& motion, int cells, double part, double courant = 0.2) {
    const Simulation& s = a.simulation;
    const int steps = static_cast<int>(std::ceil(part * 2 / courant * cells / motion.mode - 1e-9));  // a period is 2/(k c)
    const double dt = part * motion.period() / steps;
    const Measures first = s.measure();
    s.sample(0, 0);
    double work = 0, impulse = 0;
    for (int k = 0; k < steps; ++k) {
        s.step(k * dt, dt);
        const Supply supply = s.supply(k * dt, dt);
        work += supply.work;
        impulse += supply.impulse[0];
        s.sample((k + 1) * dt, 0);
    }
    const Measures last = s.measure();
    const double drift = last.balance() - first.balance() - work, lost = last.momentum[0] - first.momentum[0] - impulse;
    const auto errors = a.errors(0);
    return {errors[0].value,      errors[1].value,       errors[2].value, first.kinetic,
            work / first.kinetic, drift / first.kinetic, lost / first.momentum_in_play};
}

/// With two particles per cell, at the Gauss points for finite elements.
inline SegmentSettings segment_settings(double G, int ppc = 2, const std::string& placing = "mid") {
    SegmentSettings s;
    s.scene.G = G;
    s.scene.placing = placing;
    s.common.ppc = ppc;
    return s;
}
template <class Scheme, class Kernel = Hat> SegmentRun run_segment(SegmentSettings s, int cells, double part = 1) {
    if (is_fem<Scheme>) s.scene.placing = "gauss";
    return run_segment(segment_with<Kernel, total_lagrangian<Scheme>>(s, Scheme{}, SegmentTransfer<Scheme>{}, cells), s.scene, cells, part);
}
template <class Scheme, class Kernel = Hat> double e1(double G, int cells) {
    return run_segment<Scheme, Kernel>(segment_settings(G), cells).e1;
}

/// Every order between neighbours of 2^4 ... 2^7 cells lies in [low, high].
template <class Scheme, class Kernel = Hat> void expect_order(const SegmentSettings& s, double low, double high) {
    double before = 0;
    for (const int cells : {16, 32, 64, 128}) {
        const double now = run_segment<Scheme, Kernel>(s, cells).e1;
        if (before > 0) {
            EXPECT_GE(std::log2(before / now), low) << cells;
            EXPECT_LE(std::log2(before / now), high) << cells;
        }
        before = now;
    }
}

}  // namespace mpm::test
