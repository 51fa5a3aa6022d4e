/// The watch for volumetric locking: nearly incompressible solids whose cells have more particles, each asking for its own volume, than
/// motions that could give it to them (review 5.2).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

#include "lab/monitor.hpp"

namespace mpm {

/// A body that locks bends too little, and says nothing of it: energy and momentum are kept. Its pressure tells. In a cell its particles
/// press against one another, up and down by turns, with a mean that is as nothing to its parts, and far harder than any shear. So locking
/// is called where the pressures of particles that began in one cell differ from their mean by more than 0.9 of the rms pressure, and by
/// more than twice the rms shear, at `patience` records in a row. A cantilever of 16 x 4 cells: 0.36 and 0.4 at nu = 0.3 (3 % of its tip's
/// way missing), 0.75 and 1.3 at 0.45 (14 %), 0.96 and 5 at 0.49 (41 %), 0.99 and 20 at 0.499 (82 %); with F-bar below 0.25 and 0.3.
template <class Matter> class LockingWatch {
public:
    static constexpr double scattered = 0.9, over_shear = 2;
    static constexpr int patience = 5;

    /// Rounding is no pressure: a part of 1e-10 of rho c^2, c the P-wave speed.
    LockingWatch(const Matter& body, double wave_speed) {
        const auto& lattice = body.grid.lattice();
        cell_.reserve(body.points.size());
        std::size_t most = 0;
        double m = 0, V0 = 0;
        for (const auto& p : body.points) {
            m += p.m, V0 += p.V0;
            std::size_t cell = 0;
            for (int d = Matter::D; d-- > 0;)
                cell = cell * static_cast<std::size_t>(lattice.cells(d)) + static_cast<std::size_t>(lattice.in_cells(p.x[d], d));
            cell_.push_back(cell);
            most = std::max(most, cell + 1);
        }
        sums_.resize(most);
        if (V0 > 0) least_ = 1e-10 * m / V0 * wave_speed * wave_speed;
    }

    Trouble check(const Matter& body) {
        for (auto& sum : sums_) sum = {};
        double volume = 0, shear2 = 0, scatter2 = 0, pressure2 = 0;
        for (std::size_t i = 0; i < body.points.size(); ++i) {
            const auto& p = body.points[i];
            const double pressure = -p.sigma.trace() / Matter::D;
            shear2 += p.V * (p.sigma + pressure * identity<Matter::D>()).squaredNorm() / 2;
            pressure2 += p.V * pressure * pressure;
            volume += p.V;
            auto& [V, first, second] = sums_[cell_[body.number(i)]];
            V += p.V, first += p.V * pressure, second += p.V * pressure * pressure;
        }
        for (const auto& [V, first, second] : sums_)
            if (V > 0) scatter2 += second - first * first / V;
        const bool locked = scatter2 > scattered * scattered * pressure2 && scatter2 > over_shear * over_shear * shear2 &&
                            scatter2 > least_ * least_ * volume;
        records_ = locked ? records_ + 1 : 0;
        if (records_ < patience) return {};
        std::ostringstream s;
        s << "pressures of particles that began in one cell differ from their mean by " << 100 * std::sqrt(scatter2 / pressure2)
          << " % of the rms pressure, " << std::sqrt(scatter2 / shear2)
          << " times the rms shear: the body is too stiff; F-bar (--fbar) or smooth functions help";
        return {"locking", s.str()};
    }

private:
    double least_ = 0;                          // pressure [stress]
    std::vector<std::size_t> cell_;             // of each particle, by its number
    std::vector<std::array<double, 3>> sums_;   // volume, times pressure, times its square, of each cell
    int records_ = 0;                           // in a row
};

/// Nearly incompressible solids do, from nu = 0.476 on; their laws tell lambda and mu.
template <class Law> bool can_lock(const Law& law) {
    if constexpr (requires { law.lambda / law.mu; })
        return law.lambda > 20 * law.mu;
    else
        return false;
}

}  // namespace mpm
