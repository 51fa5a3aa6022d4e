/// A rectilinear grid of finite elements: its lines may lie at any distance (layers of different height), neighbours share nodes.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#include "lab/math.hpp"
#include "lab/stencil.hpp"

namespace mpm {

/// Where the elements along one axis begin and end, in ascending order [length].
using Lines = std::vector<double>;

inline Lines even_lines(double from, double to, int elements) {
    Lines lines;
    for (int i = 0; i <= elements; ++i) lines.push_back(from + (to - from) * i / elements);
    return lines;
}
/// Every element halved, `times` over.
inline Lines halved(Lines lines, int times) {
    for (; times > 0; --times) {
        Lines finer{lines.front()};
        for (std::size_t i = 1; i < lines.size(); ++i) finer.insert(finer.end(), {(lines[i - 1] + lines[i]) / 2, lines[i]});
        lines = finer;
    }
    return lines;
}

/// How elements share nodes along an axis: an element has `count` of them, those of its neighbour begin `stride` further. {2, 1} for
/// linear, {3, 2} for quadratic Lagrange elements, {3, 1} for quadratic splines.
struct Sharing {
    int count = 2, stride = 1;
};

/// Elements and nodes are numbered fastest along the first axis.
template <int D> class Rectilinear {
public:
    /// Throws std::bad_alloc if the nodes cannot be counted.
    explicit Rectilinear(const std::array<Lines, D>& lines, Sharing sharing = {}) : lines_(lines), sharing_(sharing) {
        double all = D;
        for (int d = 0; d < D; ++d) all *= nodes(d);
        if (all > std::numeric_limits<int>::max()) throw std::bad_alloc();
    }
    Rectilinear() : Rectilinear([] {
        std::array<Lines, D> unit;
        unit.fill(Lines{0, 1});
        return unit;
    }()) {}

    const Lines& lines(int axis) const { return lines_[at(axis)]; }
    Sharing sharing() const { return sharing_; }
    int elements(int axis) const { return static_cast<int>(lines(axis).size()) - 1; }
    int elements() const {
        int n = 1;
        for (int d = 0; d < D; ++d) n *= elements(d);
        return n;
    }
    int nodes(int axis) const { return (elements(axis) - 1) * sharing_.stride + sharing_.count; }
    int size() const {
        int n = 1;
        for (int d = 0; d < D; ++d) n *= nodes(d);
        return n;
    }
    int nodes_per_element() const { return power(sharing_.count, D); }
    /// Place of a node along an axis, counted from the lower corner.
    int along(int node, int axis) const { return axis == 0 ? node % nodes(0) : node / nodes(0); }

    /// Place of an element along an axis.
    int place(int element, int axis) const { return axis == 0 ? element % elements(0) : element / elements(0); }
    double low(int element, int axis) const { return lines(axis)[static_cast<std::size_t>(place(element, axis))]; }
    double size(int element, int axis) const {
        return lines(axis)[static_cast<std::size_t>(place(element, axis)) + 1] - low(element, axis);
    }

    /// Node k of an element, 0 <= k < nodes_per_element(), fastest along the first axis.
    int node(int element, int k) const {
        int number = 0, stride = 1;
        for (int d = 0; d < D; ++d) {
            number += stride * (place(element, d) * sharing_.stride + k % sharing_.count);
            stride *= nodes(d);
            k /= sharing_.count;
        }
        return number;
    }
    /// Where a node of Lagrange elements is; of splines, the middle of its function's support if all lines are equally far apart.
    Vec<D> position(int node) const {
        Vec<D> x;
        for (int d = 0; d < D; ++d) {
            const bool lagrange = sharing_.stride == sharing_.count - 1;
            const double shift = lagrange ? 0 : 0.5 * (sharing_.count - 2);
            const double cells = static_cast<double>(along(node, d)) / sharing_.stride - shift;
            const int e = std::clamp(static_cast<int>(cells), 0, elements(d) - 1);
            const double left = lines(d)[static_cast<std::size_t>(e)], right = lines(d)[static_cast<std::size_t>(e) + 1];
            x[d] = left + (cells - e) * (right - left);
        }
        return x;
    }

    /// The element that holds x; a point between two belongs to the one with the larger number. Throws OutsideGrid.
    int element_at(const Vec<D>& x) const {
        int number = 0, stride = 1;
        for (int d = 0; d < D; ++d) {
            const Lines& l = lines(d);
            if (!(x[d] >= l.front() && x[d] <= l.back())) [[unlikely]]
                detail::outside_grid(x[d], l.front(), l.back(), d);
            const auto after = std::upper_bound(l.begin(), l.end(), x[d]) - l.begin();
            number += stride * std::min(static_cast<int>(after) - 1, elements(d) - 1);
            stride *= elements(d);
        }
        return number;
    }

private:
    static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }
    std::array<Lines, D> lines_;
    Sharing sharing_;
};

}  // namespace mpm
