/// CPDI-T3: the domain is a triangle (review 3.6.4, equations 3.40 and 3.41).
#pragma once
#include "chapters/cpdi/domain.hpp"

namespace mpm {

struct DomainT3 {
    static constexpr const char* name = "cpdi-t3";
    static constexpr int D = 2;
    static constexpr std::size_t corners = 3;

    /// Corners counter-clockwise. The gradient of a corner's function is constant: the opposite edge's inward normal over 2 V.
    static DomainWeights<2, 3> weights(const std::array<Vec<2>, 3>& x) {
        DomainWeights<2, 3> w;
        w.V = 0.5 * cross(x[1] - x[0], x[2] - x[0]);
        w.f = {1.0 / 3, 1.0 / 3, 1.0 / 3};
        const double per_2V = 0.5 / w.V;
        for (std::size_t c = 0; c < 3; ++c) w.g[c] = -edge_normal(x[(c + 1) % 3], x[(c + 2) % 3]) * per_2V;
        w.centroid = (x[0] + x[1] + x[2]) / 3;
        return w;
    }
};

}  // namespace mpm
