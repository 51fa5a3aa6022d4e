/// Functions of the elements that implicit MPM works on, and what a particle touches in its element.
#pragma once
#include <array>
#include <cstddef>

#include "lab/rectilinear.hpp"

namespace mpm {

/// Functions along an axis of one element, 0 <= s <= 1: values and derivatives by s.
template <int Count> struct LineFunctions {
    std::array<double, Count> phi, dphi;
};

struct LinearElement {
    static constexpr const char* name = "hat";
    static constexpr int count = 2, stride = 1;
    static LineFunctions<2> at(double s) { return {{1 - s, s}, {-1, 1}}; }
};
/// In two dimensions Q9, the source's element: end, middle, end.
struct QuadraticElement {
    static constexpr const char* name = "lagrange";
    static constexpr int count = 3, stride = 2;
    static LineFunctions<3> at(double s) {
        return {{(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)}, {4 * s - 3, 4 - 8 * s, 4 * s - 1}};
    }
};
/// B-splines on lines that are equally far apart; no function ends at a grid's end, so nothing can be held there.
struct QuadraticSpline {
    static constexpr const char* name = "quadratic";
    static constexpr int count = 3, stride = 1;
    static LineFunctions<3> at(double s) {
        return {{(1 - s) * (1 - s) / 2, 0.5 + s * (1 - s), s * s / 2}, {s - 1, 1 - 2 * s, s}};
    }
};
struct CubicSpline {
    static constexpr const char* name = "cubic";
    static constexpr int count = 4, stride = 1;
    static LineFunctions<4> at(double s) {
        const double r = 1 - s;
        return {{r * r * r / 6, (4 - 6 * s * s + 3 * s * s * s) / 6, (4 - 6 * r * r + 3 * r * r * r) / 6, s * s * s / 6},
                {-r * r / 2, -2 * s + 1.5 * s * s, 2 * r - 1.5 * r * r, s * s / 2}};
    }
};

template <class Element> constexpr Sharing sharing_of() { return {Element::count, Element::stride}; }

/// Weights [-] and gradients [1/length] of an element's functions at a point. `trial` are the gradients that strain the point: those of the
/// functions, unless contact recedes (receding.hpp).
template <int D, int N> struct ElementWeights {
    std::array<double, N> phi;
    std::array<Vec<D>, N> grad, trial;
};

template <class Element, int D>
ElementWeights<D, power(Element::count, D)> element_weights(const Rectilinear<D>& grid, int element, const Vec<D>& x) {
    std::array<LineFunctions<Element::count>, D> line;
    for (int d = 0; d < D; ++d)
        line[static_cast<std::size_t>(d)] = Element::at((x[d] - grid.low(element, d)) / grid.size(element, d));
    ElementWeights<D, power(Element::count, D)> w;
    for (std::size_t k = 0; k < w.phi.size(); ++k) {
        const std::array<std::size_t, 2> i{k % Element::count, k / Element::count};
        w.phi[k] = 1;
        w.grad[k] = Vec<D>::Ones();
        for (int d = 0; d < D; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            w.phi[k] *= line[axis].phi[i[axis]];
            for (int e = 0; e < D; ++e) w.grad[k][e] *= e == d ? line[axis].dphi[i[axis]] / grid.size(element, d) : line[axis].phi[i[axis]];
        }
    }
    w.trial = w.grad;
    return w;
}

}  // namespace mpm
