/// A weighting function sampled for drawing, and how far it is from what every weighting function must satisfy (review 3.1).
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "chapters/weighting/tensor.hpp"

namespace mpm {

/// The largest deviations found: |sum of weights - 1|, |sum of gradients|, |gradient - central difference|; and the smallest weight.
struct Deviations {
    double unity = 0, gradients = 0, difference = 0, smallest = std::numeric_limits<double>::infinity();
};

/// On a grid of unit cells, so that lengths are in cells. Of the line [node][sample]; of the square the middle node at [sample].
struct Sampled {
    std::string name;
    std::vector<std::vector<double>> phi, grad;
    std::vector<double> surface, surface_dx;
    Deviations deviations;
};

/// Even places over `cells` cells. A jump is drawn upright: each inner cell edge is there twice, first just below it.
inline std::vector<double> line_places(int cells, int per_cell) {
    std::vector<double> at;
    for (int cell = 0; cell < cells; ++cell)
        for (int k = 0; k <= per_cell; ++k) {
            const bool below = k == per_cell && cell + 1 < cells;
            at.push_back(below ? std::nextafter(cell + 1.0, 0.0) : cell + static_cast<double>(k) / per_cell);
        }
    return at;
}

/// n by n places, x running fastest.
inline std::vector<Vec<2>> square_places(int n, double spacing) {
    std::vector<Vec<2>> at;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) at.push_back(Vec<2>(i * spacing, j * spacing));
    return at;
}

/// A particle as the GIMP functions ask for it: stretched by `stretch` along each axis.
template <int D>
struct Probe {
    Mat<D> F;
};

/// Weights and gradients of all nodes at x.
template <int D>
struct AtPlace {
    std::vector<double> phi;
    std::vector<Vec<D>> grad;
};
template <int D, class Shape>
AtPlace<D> all_nodes(const Shape& shape, const Probe<D>& p, const Vec<D>& x) {
    const auto n = static_cast<std::size_t>(shape.lattice.size());
    AtPlace<D> a{std::vector<double>(n, 0.0), std::vector<Vec<D>>(n, Vec<D>::Zero())};
    for (const auto& e : shape.at(x, p)) {
        a.phi[static_cast<std::size_t>(e.node)] += e.phi;
        a.grad[static_cast<std::size_t>(e.node)] += e.grad;
    }
    return a;
}

/// Sums at x, and gradients against central differences a little further on, away from the cell edges where some functions have a kink.
template <int D, class Shape>
void deviate(Deviations& worst, const Shape& shape, const Probe<D>& p, const Vec<D>& x, double aside) {
    const AtPlace<D> here = all_nodes<D>(shape, p, x);
    double sum = -1;
    Vec<D> gradients = Vec<D>::Zero();
    for (std::size_t I = 0; I < here.phi.size(); ++I) {
        sum += here.phi[I];
        gradients += here.grad[I];
        worst.smallest = std::min(worst.smallest, here.phi[I]);
    }
    worst.unity = std::max(worst.unity, std::abs(sum));
    worst.gradients = std::max(worst.gradients, gradients.cwiseAbs().maxCoeff());
    const Vec<D> y = x + Vec<D>::Constant(aside);
    if (y.maxCoeff() > shape.lattice.upper()[0]) return;
    const AtPlace<D> there = all_nodes<D>(shape, p, y);
    for (int d = 0; d < D; ++d) {
        Vec<D> step = Vec<D>::Zero();
        step[d] = 1e-5;
        const AtPlace<D> up = all_nodes<D>(shape, p, y + step), down = all_nodes<D>(shape, p, y - step);
        for (std::size_t I = 0; I < up.phi.size(); ++I)
            worst.difference = std::max(worst.difference, std::abs((up.phi[I] - down.phi[I]) / 2e-5 - there.grad[I][d]));
    }
}

/// Samples `kernel` on a line and, with `coarse` samples per cell and axis, on a square of cells.
template <class Kernel>
Sampled sample(const Kernel& kernel, double stretch, int cells, int per_cell, int coarse) {
    Sampled s;
    s.name = Kernel::name;
    const Tensor<1, Kernel> line{{Vec<1>(0.0), Vec<1>(1.0), {cells}, Kernel::per_cell}, kernel};
    const Tensor<2, Kernel> square{{Vec<2>(0, 0), Vec<2>(1, 1), {cells, cells}, Kernel::per_cell}, kernel};
    const Probe<1> p{stretch * Mat<1>::Identity()};
    const Probe<2> q{stretch * Mat<2>::Identity()};
    s.phi.resize(static_cast<std::size_t>(line.lattice.size()));
    s.grad.resize(s.phi.size());
    for (const double x : line_places(cells, per_cell)) {
        const auto a = all_nodes<1>(line, p, Vec<1>(x));
        for (std::size_t I = 0; I < s.phi.size(); ++I) s.phi[I].push_back(a.phi[I]), s.grad[I].push_back(a.grad[I][0]);
        deviate<1>(s.deviations, line, p, Vec<1>(x), 0.4 / per_cell);
    }
    const int middle = square.lattice.nodes(0) / 2;
    const auto node = static_cast<std::size_t>(middle * square.lattice.nodes(0) + middle);
    for (const Vec<2>& x : square_places(cells * coarse + 1, 1.0 / coarse)) {
        const auto a = all_nodes<2>(square, q, x);
        s.surface.push_back(a.phi[node]);
        s.surface_dx.push_back(a.grad[node][0]);
        deviate<2>(s.deviations, square, q, x, 0.4 / coarse);
    }
    return s;
}

}  // namespace mpm
