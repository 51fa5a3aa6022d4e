/// The state that every explicit scheme of review section 2 keeps on a particle and on a node. Any consistent units.
#pragma once
#include <tuple>

#include "lab/math.hpp"

namespace mpm {

/// A material point; a scene or a transfer extends it where it needs more.
template <int Dim> struct Point {
    static constexpr int D = Dim;
    double m = 0, V0 = 0, V = 0;                                     // mass, initial and current volume
    Vec<D> X = Vec<D>::Zero(), x = Vec<D>::Zero(), v = Vec<D>::Zero();  // initial and current position, velocity
    Mat<D> F = identity<D>(), sigma = Mat<D>::Zero();                // deformation gradient, Cauchy stress
};

/// A grid node of the explicit schemes.
template <int Dim> struct Node {
    static constexpr int D = Dim;
    double m = 0;                                                    // mass
    Vec<D> mv = Vec<D>::Zero(), mv_new = Vec<D>::Zero();             // momentum at t, at t + dt
    Vec<D> f = Vec<D>::Zero();                                       // force
    Vec<D> v = Vec<D>::Zero(), v_new = Vec<D>::Zero();               // velocity at t, at t + dt
    void reset() { *this = Node(); }
    static constexpr auto sums() { return std::tuple(&Node::m, &Node::mv, &Node::mv_new, &Node::f); }  // chapters/cpdi
    static constexpr auto fields() { return std::tuple(&Node::v, &Node::v_new); }
};

/// (m v) / m, and zero where no mass is: no division by a small mass is hidden, `m > 0` is exact.
template <int D> Vec<D> velocity(const Vec<D>& mv, double m) { return m > 0 ? Vec<D>(mv / m) : Vec<D>(Vec<D>::Zero()); }

}  // namespace mpm
