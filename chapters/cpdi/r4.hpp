/// CPDI-R4: the domain, a rectangle at first, stays a parallelogram that F carries along (review 3.6.2, equations 3.27 to 3.35).
#pragma once
#include "chapters/cpdi/q4.hpp"

namespace mpm {

/// Corners x -+ r1 -+ r2 with r_i = F r_i^0, r_i^0 half an edge of the rectangle (3.27), (3.34). Nothing joins the corners of neighbours:
/// where F differs from particle to particle, gaps and overlaps open (figure 25). With MUSL they open in uniaxial strain too, where USL has
/// none: it moves particles with one velocity and strains them with another.
struct DomainR4 {
    static constexpr const char* name = "cpdi-r4";
    static constexpr int D = 2;
    static constexpr std::size_t corners = 4;

    template <class Point> static std::array<Vec<2>, 4> corners_of(const Point& p, const Vec<2>& half) {
        const Vec<2> r1 = p.F.col(0) * half[0], r2 = p.F.col(1) * half[1];
        return {p.x - r1 - r2, p.x + r1 - r2, p.x + r1 + r2, p.x - r1 + r2};
    }
    /// (3.32). The printed V of (3.35) is a norm; with its sign the gradient is right for an inverted domain too.
    static DomainWeights<2, 4> weights(const std::array<Vec<2>, 4>& x) {
        const Vec<2> r1 = 0.5 * (x[1] - x[0]), r2 = 0.5 * (x[3] - x[0]);
        DomainWeights<2, 4> w;
        w.V = 4 * cross(r1, r2);
        w.f = {0.25, 0.25, 0.25, 0.25};
        const Vec<2> g0 = edge_normal(r2, r1) / w.V, g1 = edge_normal(-r1, r2) / w.V;
        w.g = {g0, g1, -g0, -g1};
        w.centroid = 0.5 * (x[0] + x[2]);
        return w;
    }
};

}  // namespace mpm
