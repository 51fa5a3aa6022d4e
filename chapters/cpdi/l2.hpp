/// CPDI-L2: the domain of a particle in 1D is a line between two corners (review 3.6.1, equation 3.26).
#pragma once
#include "chapters/cpdi/domain.hpp"

namespace mpm {

struct DomainL2 {
    static constexpr const char* name = "cpdi-l2";
    static constexpr int D = 1;
    static constexpr std::size_t corners = 2;

    /// Ends of the domain where F carries it: cpGIMP's domain.
    template <class Point> static std::array<Vec<1>, 2> corners_of(const Point& p, const Vec<1>& half) {
        return {p.x - p.F * half, p.x + p.F * half};
    }
    static DomainWeights<1, 2> weights(const std::array<Vec<1>, 2>& x) {
        const double l = x[1][0] - x[0][0];
        return {{0.5, 0.5}, {Vec<1>(-1 / l), Vec<1>(1 / l)}, l, 0.5 * (x[0] + x[1])};
    }
};

}  // namespace mpm
