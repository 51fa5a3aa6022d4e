/// The watch over particle domains: turned inside out, crossing themselves, collapsed, or too long for their weights.
#pragma once
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "chapters/cpdi/domain.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// Whether the edges a b and c d cross; touching ends do not count.
inline bool edges_cross(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
    const double s = cross(b - a, c - a), t = cross(b - a, d - a), u = cross(d - c, a - c), v = cross(d - c, b - c);
    return s * t < 0 && u * v < 0;
}

/// What is wrong with a domain, or "": corners in order about a body's particle, `h` the grid's cells. CPDI sees the grid at corners
/// alone: a domain longer than three cells has cells between its corners that it does not touch, and another particle slips through
/// (review 3.7).
template <class Domain> std::string domain_fault(const Domain& x, const Vec<2>& h) {
    const std::size_t n = x.size();
    double twice_area = 0, longest = 0;
    Vec<2> low = x[0], high = x[0];
    for (std::size_t c = 0; c < n; ++c) {
        const Vec<2> edge = x[(c + 1) % n] - x[c];
        twice_area += cross(x[c] - x[0], x[(c + 1) % n] - x[0]);
        longest = std::max(longest, edge.squaredNorm());
        low = low.cwiseMin(x[c]), high = high.cwiseMax(x[c]);
    }
    std::ostringstream s;
    if (!(twice_area > 0)) return s << "is turned inside out: area " << twice_area / 2, s.str();
    if (twice_area < 1e-6 * longest)
        return s << "has collapsed: area " << twice_area / 2 << ", longest edge " << std::sqrt(longest), s.str();
    for (std::size_t c = 0; c < n; ++c)
        for (std::size_t k = c + 2; k < n && k - c < n - 1; ++k)
            if (edges_cross(x[c], x[(c + 1) % n], x[k], x[(k + 1) % n])) return "crosses itself";
    if (n == 4)  // of convex ones all corners turn left; a dart's weights may look well
        for (std::size_t c = 0; c < 4; ++c)
            if (!(cross(x[(c + 1) % 4] - x[c], x[(c + 2) % 4] - x[(c + 1) % 4]) > 0)) return "is a dart, its map is not one to one";
    const Vec<2> cells = (high - low).cwiseQuotient(h);
    if (cells.maxCoeff() > 3) return s << "spans " << cells.maxCoeff() << " cells, at most 3 are seen by its corners; split it", s.str();
    return {};
}

/// The first domain of a shape that has a fault; `h` the grid's cells.
template <class Shape, class Points> Trouble check_domains(const Shape& shape, const Points& points, const Vec<2>& h) {
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const auto corners = shape.corners_of(i);
        const std::string fault = domain_fault(corners, h);
        if (fault.empty()) continue;
        std::ostringstream s;
        s << "the domain of " << detail::place(i, points[i]) << " " << fault;
        return {"domain-trouble", s.str()};
    }
    return {};
}

}  // namespace mpm
