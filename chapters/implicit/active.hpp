/// The active grid of a step: particles sorted by element, the flags M_E and the soft stiffness (Aulisa and Capodaglio, 3.3, equations 26
/// and 27).
#pragma once
#include <cstddef>
#include <vector>

#include "chapters/implicit/element.hpp"
#include "lab/fill.hpp"

namespace mpm {

/// C_E by the flag M_E out of N nodes: (50), (51) and (53) in this form.
struct SoftTable {
    double few = 0, some = 0;  // where less than half of the nodes count, and where not all do [-]
    double of(int M, int N) const { return M == N ? 0 : 2 * M <= N ? few : some; }
};

template <int D> struct ActiveGrid {
    std::vector<int> elements;                    // with particles, in ascending order
    std::vector<int> flags;                       // their M_E
    std::vector<std::size_t> begin, particles;    // of element e: particles[begin[e]] ... particles[begin[e + 1] - 1]
    std::vector<char> node_is_active;             // of each node of the grid

    template <class Points> void sort(const Rectilinear<D>& grid, const Points& points) {
        sort(grid, points, [&](std::size_t p) { return grid.element_at(points[p].x); });
    }
    /// `element_of(p)` holds particle p; `full` are elements without particles that are no emptier for it, those of a finite element body.
    template <class Points, class ElementOf>
    void sort(const Rectilinear<D>& grid, const Points& points, ElementOf&& element_of, const std::vector<int>& full = {}) {
        std::vector<int> element(points.size());
        std::vector<std::size_t> count(static_cast<std::size_t>(grid.elements()) + 1, 0);
        for (std::size_t p = 0; p < points.size(); ++p) {
            element[p] = element_of(p);
            ++count[static_cast<std::size_t>(element[p]) + 1];
        }
        elements.clear();
        begin.assign(1, 0);
        for (std::size_t e = 0; e + 1 < count.size(); ++e) {
            if (count[e + 1] > 0) elements.push_back(static_cast<int>(e)), begin.push_back(begin.back() + count[e + 1]);
            count[e + 1] += count[e];
        }
        particles.resize(points.size());
        for (std::size_t p = 0; p < points.size(); ++p) particles[count[static_cast<std::size_t>(element[p])]++] = p;
        flag(grid, full);
    }

private:
    /// M_E starts from the number of nodes and loses one for each that an element without particles has too.
    void flag(const Rectilinear<D>& grid, const std::vector<int>& full) {
        const int N = grid.nodes_per_element();
        std::vector<char> holds(static_cast<std::size_t>(grid.elements()), 0), touches_empty(static_cast<std::size_t>(grid.size()), 0);
        node_is_active.assign(static_cast<std::size_t>(grid.size()), 0);
        for (const int e : elements) holds[static_cast<std::size_t>(e)] = 1;
        for (const int e : full) holds[static_cast<std::size_t>(e)] = 1;
        for (int e = 0; e < grid.elements(); ++e)
            for (int k = 0; k < N; ++k)
                (holds[static_cast<std::size_t>(e)] ? node_is_active : touches_empty)[static_cast<std::size_t>(grid.node(e, k))] = 1;
        flags.clear();
        for (const int e : elements) {
            int M = N;
            for (int k = 0; k < N; ++k) M -= touches_empty[static_cast<std::size_t>(grid.node(e, k))];
            flags.push_back(M);
        }
    }
};

/// Visits the Gauss points of an element with its weights there and the volume that belongs to the point.
template <class Element, int D, class Visit> void each_gauss_point(const Rectilinear<D>& grid, int element, Visit&& visit) {
    static const CellRule rule = gauss_points(Element::count);
    for (std::size_t q = 0; q < static_cast<std::size_t>(power(Element::count, D)); ++q) {
        const std::array<std::size_t, 2> i{q % Element::count, q / Element::count};
        Vec<D> x;
        double volume = 1;
        for (int d = 0; d < D; ++d) {
            const std::size_t along = i[static_cast<std::size_t>(d)];
            x[d] = grid.low(element, d) + rule.at[along] * grid.size(element, d);
            volume *= rule.part[along] * grid.size(element, d);
        }
        visit(element_weights<Element, D>(grid, element, x), volume);
    }
}

/// (26): the integral of (grad u + grad u^T) . grad phi_I, row by row, without the factor mu C_E. It acts on the increment of a step, so
/// that it is a viscosity mu C_E dt rather than a stiffness.
template <class Element, int D> auto soft_matrix(const Rectilinear<D>& grid, int element) {
    constexpr int N = power(Element::count, D);
    Eigen::Matrix<double, N * D, N * D, Eigen::RowMajor> K = Eigen::Matrix<double, N * D, N * D, Eigen::RowMajor>::Zero();
    each_gauss_point<Element>(grid, element, [&](const auto& w, double volume) {
        for (int i = 0; i < N; ++i)
            for (int k = 0; k < N; ++k) {
                const auto &g = w.grad[static_cast<std::size_t>(i)], &h = w.grad[static_cast<std::size_t>(k)];
                for (int c = 0; c < D; ++c) {
                    K(i * D + c, k * D + c) += volume * h.dot(g);
                    for (int d = 0; d < D; ++d) K(i * D + c, k * D + d) += volume * h[c] * g[d];
                }
            }
    });
    return K;
}

}  // namespace mpm
