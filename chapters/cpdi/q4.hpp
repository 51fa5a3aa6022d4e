/// CPDI-Q4 (CPDI2): the domain is a quadrilateral (review 3.6.3, equations 3.36, 3.37, 3.39).
#pragma once
#include "chapters/cpdi/domain.hpp"

namespace mpm {

struct DomainQ4 {
    static constexpr const char* name = "cpdi-q4";
    static constexpr int D = 2;
    static constexpr std::size_t corners = 4;

    /// Corners counter-clockwise (clockwise ones give the same weights with V < 0). a and b measure how far opposite edges are from
    /// parallel; in a parallelogram both vanish and the function weights are 1/4.
    static DomainWeights<2, 4> weights(const std::array<Vec<2>, 4>& x) {
        DomainWeights<2, 4> w;
        w.V = 0.5 * cross(x[2] - x[0], x[3] - x[1]);
        const double a = cross(x[3] - x[0], x[1] - x[2]), b = cross(x[2] - x[3], x[0] - x[1]);
        const double per_2V = 0.5 / w.V, p = (a + b) * per_2V / 12, q = (a - b) * per_2V / 12;
        w.f = {0.25 - p, 0.25 - q, 0.25 + p, 0.25 + q};
        const Vec<2> g0 = edge_normal(x[3], x[1]) * per_2V, g1 = edge_normal(x[0], x[2]) * per_2V;
        w.g = {g0, g1, -g0, -g1};
        for (std::size_t c = 0; c < 4; ++c) w.centroid += w.f[c] * x[c];
        return w;
    }
};

}  // namespace mpm
