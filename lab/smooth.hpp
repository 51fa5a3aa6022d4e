/// Fields of particles smoothed through the grid (review 4.10): mapped to the nodes with the particles' masses, and back.
///
/// f_I = sum_p phi_I(x_p) m_p f_p / sum_p phi_I(x_p) m_p, and f_p <- sum_I phi_I(x_p) f_I. Since the weights of a particle sum to one,
/// sum_p m_p f_p stays what it was and a constant stays itself, wherever the particles are. A linear field stays itself where the functions
/// reproduce linear fields and the particles around every node that is touched lie as mirror images of each other.
#pragma once
#include <cstddef>
#include <vector>

#include "lab/body.hpp"

namespace mpm {

/// The nodes and weights of every particle of a body as plain numbers: all that smoothing needs of its weighting function.
struct Mapping {
    std::size_t touched = 0;  // nodes of each particle
    std::vector<int> node;    // [particle * touched + k]
    std::vector<double> phi;  // [-], likewise
};

/// Appends one particle's.
template <int D> [[gnu::noinline, gnu::cold]] void append(Mapping& map, const StencilEntry<D>* first, std::size_t touched) {
    map.touched = touched;
    for (const StencilEntry<D>* entry = first; entry != first + touched; ++entry)
        map.node.push_back(entry->node), map.phi.push_back(entry->phi);
}
/// Compiled for every weighting function and every kind of point, so kept small. Throws OutsideGrid.
template <class Shape, class Point> [[gnu::noinline, gnu::cold]] Mapping mapping_of(const Shape& shape, const std::vector<Point>& points) {
    Mapping map;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& stencil = shape(points[i], i);
        append<Point::D>(map, stencil.data(), stencil.size());
    }
    return map;
}

/// `field` has as many values for each particle as it has components; `m` are the masses.
std::vector<double> smoothed(const Mapping& map, const std::vector<double>& m, const std::vector<double>& field);

}  // namespace mpm
