/// What a particle domain gives to the weighting functions of CPDI (review 3.6): each corner's function and gradient weight.
///
/// CPDI replaces the hat functions inside a domain by interpolation between the domain's corners, N(x) ~ sum_c M_c(x) N(x_c) (3.29), so
/// that the means over the domain of function and gradient are (3.30), (3.31)
///   phi = sum_c w_f[c] N(x_c),  grad phi = sum_c w_g[c] N(x_c),  w_f[c] = 1/V int M_c,  w_g[c] = 1/V int grad M_c.
/// So sum w_f = 1 and sum w_g = 0, for every domain whose V is not zero.
#pragma once
#include <array>
#include <cstddef>

#include "lab/math.hpp"

namespace mpm {

/// Weights of N corners, the domain's volume (negative if the corners run clockwise) and its centroid.
template <int D, std::size_t N> struct DomainWeights {
    std::array<double, N> f{};     // function weights [-]
    std::array<Vec<D>, N> g{};     // gradient weights [1/length]
    double V = 0;                  // volume; area in 2D
    Vec<D> centroid = Vec<D>::Zero();
};

/// Twice the signed area of the triangle a, b, c; the z component of a x b.
inline double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }
/// The outward normal of an edge of a counter-clockwise domain, as long as the edge.
inline Vec<2> edge_normal(const Vec<2>& from, const Vec<2>& to) { return {to[1] - from[1], from[0] - to[0]}; }

}  // namespace mpm
