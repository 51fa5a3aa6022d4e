/// Which points are near a place: their numbers by the cell they lie in.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lab/grid.hpp"
#include "lab/stencil.hpp"

namespace mpm {

template <int D> class NearPoints {
public:
    NearPoints() = default;
    /// Points with a position x. One outside the lattice throws OutsideGrid.
    template <class Points> void fill(const Lattice<D>& lattice, const Points& points) {
        lattice_ = lattice;
        start_.assign(static_cast<std::size_t>(cell_count()) + 1, 0);
        cell_.resize(points.size());
        numbers_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            cell_[i] = static_cast<std::uint32_t>(cell_of(points[i].x));
            ++start_[cell_[i] + 1];
        }
        for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
        for (std::size_t i = 0; i < points.size(); ++i) numbers_[start_[cell_[i]]++] = static_cast<std::uint32_t>(i);
        for (std::size_t c = start_.size() - 1; c > 0; --c) start_[c] = start_[c - 1];
        start_[0] = 0;
    }

    const Lattice<D>& lattice() const { return lattice_; }
    int cell_count() const {
        int n = 1;
        for (int d = 0; d < D; ++d) n *= lattice_.cells(d);
        return n;
    }
    /// The cell of a point; cells run fastest along the first axis.
    int cell(std::size_t point) const { return static_cast<int>(cell_[point]); }
    /// Points in a cell.
    std::size_t count(int cell) const { return start_[static_cast<std::size_t>(cell) + 1] - start_[static_cast<std::size_t>(cell)]; }

    /// Visits the numbers of all points within `reach` along each axis, and some beyond.
    template <class Visit> void visit(const Vec<D>& x, const Vec<D>& reach, Visit&& visit) const {
        std::array<int, 2> low{}, high{};
        for (int d = 0; d < D; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            low[axis] = place(x[d] - reach[d], d);
            high[axis] = place(x[d] + reach[d], d);
        }
        for (int j = low[1]; j <= high[1]; ++j) {  // the cells of a row lie side by side
            const int row = j * lattice_.cells(0);
            const std::size_t end = start_[static_cast<std::size_t>(row + high[0]) + 1];
            for (std::size_t k = start_[static_cast<std::size_t>(row + low[0])]; k < end; ++k) visit(numbers_[k]);
        }
    }

private:
    /// The cell along an axis, the nearest one for places beyond the lattice.
    int place(double x, int axis) const {
        return static_cast<int>(std::clamp((x - lattice_.origin()[axis]) * lattice_.per_h()[axis], 0.0, lattice_.cells(axis) - 1.0));
    }
    int cell_of(const Vec<D>& x) const {
        int cell = 0;
        for (int d = D - 1; d >= 0; --d) {
            if (!lattice_.holds(x[d], d)) detail::outside_grid(x[d], lattice_.origin()[d], lattice_.upper()[d], d);
            cell = cell * lattice_.cells(d) + place(x[d], d);
        }
        return cell;
    }

    Lattice<D> lattice_;
    std::vector<std::uint32_t> start_, numbers_, cell_;
};

}  // namespace mpm
