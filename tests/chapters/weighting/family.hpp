/// The weighting functions under test, and the points and grids they are tested at.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"

namespace mpm::test {

template <int D> struct Particle {
    Vec<D> x = Vec<D>::Zero(), X = Vec<D>::Zero();
    Mat<D> F = identity<D>();
};

/// One member: a kernel, how smooth it is (C^Order), and its particle size in hundredths of a cell (0: it has none).
template <class KernelType, int Order, int Hundredths = 0> struct Member {
    using Kernel = KernelType;
    static constexpr int order = Order;
    static constexpr double l = Hundredths / 100.0;
    static Kernel kernel() {
        Kernel k;
        if constexpr (requires { k.l0; }) k.l0 = l;
        if constexpr (requires { k.l; }) k.l = l;
        return k;
    }
};

using Members = ::testing::Types<Member<Hat, 0>, Member<Ugimp, 1, 100>, Member<Ugimp, 1, 50>, Member<Ugimp, 1, 10>,
                                 Member<Cpgimp, 1, 25>, Member<Cpgimp, 1, 100>, Member<Cpgimp, 1, 130>, Member<Cpgimp, 1, 200>,
                                 Member<Quadratic, 1>, Member<Cubic, 2>, Member<Bernstein, 0>, Member<Lagrange2, 0>>;

/// Where Lagrange functions differ from the rest: the smallest weight, the steepest slope at an end of the grid [per cell], and whether
/// only the first two functions have one there.
template <class Kernel> constexpr bool lagrange = std::is_same_v<Kernel, Lagrange2>;
template <class Kernel> constexpr double least_weight = lagrange<Kernel> ? -0.125 : 0;
template <class Kernel> constexpr double steepest = lagrange<Kernel> ? 4 : 2;

template <class M, int D> Tensor<D, typename M::Kernel> shape_on(const Lattice<D>& lattice) {
    return {Lattice<D>(lattice.origin(), lattice.h(), lattice.cells(), M::Kernel::per_cell), M::kernel()};
}

inline Lattice<1> line(double origin, double h, int cells) { return {Vec<1>(origin), Vec<1>(h), {cells}, 1}; }

/// Weights and gradients of all nodes at x.
struct Dense {
    std::vector<double> phi, grad;
};
template <class Shape> Dense dense(const Shape& shape, double x) {
    const auto n = static_cast<std::size_t>(shape.lattice.size());
    Dense d{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
    for (const auto& e : shape.at(Vec<1>(x), Particle<1>{})) {
        d.phi.at(static_cast<std::size_t>(e.node)) += e.phi;
        d.grad.at(static_cast<std::size_t>(e.node)) += e.grad[0];
    }
    return d;
}

/// Where pieces of a function may join, in cells: cell edges, their middles, and l/2 beside the edges.
inline std::vector<double> joints(int cells, double l) {
    std::vector<double> at;
    for (int i = 0; i <= cells; ++i)
        for (const double s : {0.0, 0.5, l / 2, -l / 2})
            if (i + s >= 0 && i + s <= cells) at.push_back(i + s);
    return at;
}

/// 1000 random places and every joint, with places 1e-12 and 1e-15 beside each; in cells, all inside.
inline std::vector<double> places(int cells, double l) {
    std::vector<double> at;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> anywhere(0, cells);
    for (int i = 0; i < 1000; ++i) at.push_back(anywhere(random));
    for (const double joint : joints(cells, l))
        for (const double s : {0.0, 1e-12, -1e-12, 1e-15, -1e-15})
            if (joint + s >= 0 && joint + s <= cells) at.push_back(joint + s);
    return at;
}

/// Grids of all sizes, far from and near to zero, the fewest cells included.
inline std::vector<Lattice<1>> lines(int min_cells) {
    std::vector<Lattice<1>> all;
    for (const int cells : {min_cells, min_cells + 1, 7})
        for (const auto& [origin, h] : std::vector<std::pair<double, double>>{
                 {0, 1}, {-3, 0.1}, {0, 1e-9}, {1e-9, 1e-9}, {0, 1e9}, {-1e9, 1e9}, {1e9, 1}, {-1e9, 1e-3}, {1e-9, 1e9}})
            all.push_back(line(origin, h, cells));
    return all;
}

}  // namespace mpm::test
