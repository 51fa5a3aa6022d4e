/// Tractions and pressures on boundary particles (review 4.2.2, equation 4.3, figure 38).
#pragma once
#include <cstddef>
#include <vector>

#include "lab/body.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// A boundary particle: its number in the body, and the area of boundary that it stands for times the outward normal, both at the start.
template <int D> struct BoundaryParticle {
    std::size_t particle;
    Vec<D> NA;  // [area; length in 2D, 1 in 1D]
    Vec<D> x;   // where it was when `supply` last asked
};

/// The loaded part of a body's boundary. Its force acts at the particles, half a particle inside the boundary: the material beyond them
/// bears nothing, which is an error of first order in the particle's size. The sum of the forces is exact: weights sum to one.
template <int D> class Traction {
public:
    std::vector<BoundaryParticle<D>> particles;

    /// Adds every particle for which where(X) holds, with the same area vector N A.
    template <class Points, class Where> void add(const Points& points, const Vec<D>& NA, Where&& where) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (where(points[i].X)) particles.push_back({i, NA, points[i].x});
    }

    /// n a, the area vector as the particle has deformed it, by Nanson's formula: n a = J F^-T N A.
    template <class Point> static Vec<D> area(const BoundaryParticle<D>& b, const Point& p) { return cofactor(p.F) * b.NA; }

    /// f_I += A_p phi_I t (4.3), with a traction t per area at the start; `current` takes the area that Nanson's formula gives.
    struct Dead {
        Vec<D> t;  // [stress]
        template <class Point> Vec<D> operator()(const BoundaryParticle<D>& b, const Point&) const { return b.NA.norm() * t; }
    };
    struct Current {
        Vec<D> t;  // [stress]
        template <class Point> Vec<D> operator()(const BoundaryParticle<D>& b, const Point& p) const { return area(b, p).norm() * t; }
    };
    /// t = -p n on the boundary as it is now.
    struct Pressure {
        double p;  // [stress]
        template <class Point> Vec<D> operator()(const BoundaryParticle<D>& b, const Point& point) const { return -p * area(b, point); }
    };

    /// Adds one of the three, or any other force(b, point), to the nodal forces: for `load` of a scene.
    template <class Body, class Force> void apply(Body& body, const Force& force) const {
        auto* nodes = &*body.grid.begin();
        for (const BoundaryParticle<D>& b : particles) {
            const auto& p = body.points[b.particle];
            const Vec<D> f = force(b, p);
            const auto& stencil = body.shape(p, b.particle);
            for (const auto& [node, phi, grad] : Weights{stencil, nodes}) node.f += phi * f;
        }
    }

    /// Impulse and work in a step, after it. The work is done on the way that the grid has moved the particles: FLIP's particle velocities
    /// are others. `force` is that at the end of the step, which for a Dead load is that at its start, for the others to first order.
    template <class Points, class Force> Supply supply(const Points& points, const Force& force, double dt) {
        Supply sum;
        for (BoundaryParticle<D>& b : particles) {
            const auto& p = points[b.particle];
            const Vec<D> f = force(b, p);
            for (int d = 0; d < D; ++d) sum.impulse[static_cast<std::size_t>(d)] += dt * f[d];
            sum.work += f.dot(p.x - b.x);
            b.x = p.x;
        }
        return sum;
    }
};

}  // namespace mpm
