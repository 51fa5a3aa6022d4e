/// Bodies that lie in each other: what happens where nothing, neither a shared grid nor a contact law, keeps them apart.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <vector>

#include "lab/body.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// Boxes of the size of a grid cell around all particles, wherever these are: those of total-Lagrangian schemes may leave their grid.
template <int D> class CellBoxes {
public:
    template <class Bodies> explicit CellBoxes(const Bodies& bodies) {
        const Lattice<D>& lattice = bodies.front()->grid.lattice();
        Vec<D> high = Vec<D>::Constant(-std::numeric_limits<double>::infinity()), low = -high;
        origin_ = lattice.origin();
        h_ = lattice.h();
        bool finite = true;
        for (const auto* body : bodies)
            for (const auto& p : body->points) {
                low = low.cwiseMin(p.x), high = high.cwiseMax(p.x);
                finite = finite && p.x.allFinite();
            }
        double boxes = 1;
        for (int d = 0; d < D; ++d) {
            first_[d] = line(low, d);
            cells_[static_cast<std::size_t>(d)] = line(high, d) - first_[d] + 1;
            boxes *= cells_[static_cast<std::size_t>(d)];
        }
        usable = finite && boxes < 1e8;
        if (usable) count_ = static_cast<std::size_t>(boxes);
    }

    bool usable = false;
    std::size_t count() const { return count_; }
    double volume() const { return h_.prod(); }
    std::size_t of(const Vec<D>& x) const {
        double cell = 0;
        for (int d = D; d-- > 0;) cell = cell * cells_[static_cast<std::size_t>(d)] + line(x, d) - first_[d];
        return static_cast<std::size_t>(cell);
    }

private:
    /// The lattice's line below x. All places are counted by it, so that rounding leaves none outside the boxes of the outermost ones.
    double line(const Vec<D>& x, int d) const { return std::floor((x[d] - origin_[d]) / h_[d]); }

    Vec<D> origin_, h_, first_;
    std::array<double, D> cells_{};
    std::size_t count_ = 0;
};

/// Two bodies pass through each other where both fill a cell by more than 0.6 and together by more than 1.4: bodies in contact share a
/// cell's room, so that their parts sum to one, but for what counting particles by their centres adds along an inclined face (a third with 3 x 3
/// to a cell at 45 degrees). Bodies are pointers to Matter. Meant for records, not for every step.
template <int D, class Bodies> Trouble check_overlap(const Bodies& bodies) {
    constexpr double filled = 0.6, together = 1.4;
    const CellBoxes<D> boxes(bodies);
    if (!boxes.usable) return {};  // a particle far away or not a number: other checks say so
    std::vector<double> volume(boxes.count()), most(boxes.count());
    std::vector<int> owner(boxes.count(), -1), last(boxes.count(), -1);
    int number = 0, cells = 0;
    std::ostringstream s;
    for (const auto* body : bodies) {
        std::fill(volume.begin(), volume.end(), 0.0);
        for (const auto& p : body->points) volume[boxes.of(p.x)] += p.V / boxes.volume();
        for (const auto& p : body->points) {
            const std::size_t cell = boxes.of(p.x);
            if (last[cell] == number) continue;
            last[cell] = number;
            if (!(volume[cell] > filled)) continue;
            if (owner[cell] >= 0 && most[cell] + volume[cell] > together && ++cells == 1)
                s << "bodies " << owner[cell] << " and " << number << " lie in each other beside x = " << p.x.transpose();
            if (volume[cell] > most[cell]) most[cell] = volume[cell], owner[cell] = number;
        }
        ++number;
    }
    if (cells == 0) return {};
    s << ": " << cells << " cell" << (cells > 1 ? "s" : "") << " filled more than " << filled << " by each of two bodies; no contact keeps them apart";
    return {"bodies-passed-through", s.str()};
}

}  // namespace mpm
