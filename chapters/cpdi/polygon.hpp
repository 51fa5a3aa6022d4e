/// CPDI with polygons of any number of corners (review 3.6.6, equations 3.44 to 3.46), split into triangles about an inner point.
#pragma once
#include <cstddef>

#include "chapters/cpdi/domain.hpp"

namespace mpm {

/// Corners counter-clockwise, n >= 3 of them. The inner point has the function weight 1/3 and the gradient weight zero, whatever its
/// place: each of the triangles gives it a third of its area, and their edges opposite to it close. A triangle needs none (3.40).
struct DomainPolygon {
    static constexpr const char* name = "cpdi-polygon";
    static constexpr int D = 2;
    static constexpr double inner_weight(std::size_t n) { return n > 3 ? 1.0 / 3 : 0; }

    struct Size {
        double V = 0;
        Vec<2> centroid = Vec<2>::Zero();
    };
    template <class Corner> static Size size(std::size_t n, Corner&& corner) {
        Size s;
        const Vec<2> o = corner(0);
        for (std::size_t c = 1; c + 1 < n; ++c) {
            const Vec<2> a = corner(c) - o, b = corner(c + 1) - o;
            const double V = 0.5 * cross(a, b);
            s.V += V;
            s.centroid += V / 3 * (a + b);
        }
        s.centroid = o + s.centroid / s.V;
        return s;
    }

    /// `corner(c)` gives corner c, `set(c, f, g)` takes its weights; the inner point is the centroid. Returns area and centroid.
    template <class Corner, class Set> static Size weights(std::size_t n, Corner&& corner, Set&& set) {
        const Size s = size(n, corner);
        for (std::size_t c = 0; c < n; ++c) {
            const Vec<2> before = corner((c + n - 1) % n), here = corner(c), after = corner((c + 1) % n);
            const double V = 0.5 * (cross(before - s.centroid, here - s.centroid) + cross(here - s.centroid, after - s.centroid));
            set(c, n > 3 ? V / (3 * s.V) : 1.0 / 3, Vec<2>(edge_normal(before, after) / (2 * s.V)));
        }
        return s;
    }
};

}  // namespace mpm
