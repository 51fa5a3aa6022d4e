/// Particle splitting (review 5.6.2): a particle whose domain has grown too long for its corners becomes several. It closes the hole of
/// review 3.7.
#pragma once
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "chapters/cpdi/parallelograms.hpp"
#include "chapters/cpdi/r4.hpp"

namespace mpm {

/// Makes `parts` equal particles of particle i, in a row along the edge `axis` of its parallelogram, which they fill. All have its velocity
/// and F, so that mass, momentum, energy and the centre of mass stay. The first takes its place, the others come last. `half`: half the
/// edges of the domains at the start.
template <class Points> void split_particle(Points& points, std::vector<Vec<2>>& half, std::size_t i, int axis, int parts) {
    const auto whole = points[i];
    half[i][axis] /= parts;
    for (int k = 0; k < parts; ++k) {
        auto part = whole;
        part.m /= parts, part.V0 /= parts, part.V /= parts;
        const double along = (2 * k + 1 - parts) * half[i][axis];
        part.X[axis] += along;
        part.x += along * whole.F.col(axis);
        if (k == 0) points[i] = part;
        else points.push_back(part), half.push_back(half[i]);
    }
}

/// Splits every particle whose domain spans more than three cells (watch.hpp) until none spans more than two along either edge: then each
/// cell between two corners has a node that one of them touches. Returns whether there was one.
template <class Points> bool split_long(Points& points, std::vector<Vec<2>>& half, const Vec<2>& h) {
    const std::size_t before = points.size();
    for (std::size_t i = 0; i < before; ++i) {
        const Mat<2> F = points[i].F;
        const auto edge = [&](int axis) { return Vec<2>(2 * half[i][axis] * F.col(axis).cwiseAbs().cwiseQuotient(h)); };  // [cells]
        if ((edge(0) + edge(1)).maxCoeff() <= 3) continue;
        for (const int axis : {0, 1}) {
            const int parts = static_cast<int>(std::ceil(edge(axis).maxCoeff() / 2));
            const std::size_t first = points.size();
            if (parts < 2) continue;
            split_particle(points, half, i, axis, parts);
            if (axis == 1) break;
            // The others are as long along the second edge: they are split there when their turn comes.
            const int across = static_cast<int>(std::ceil(edge(1).maxCoeff() / 2));
            for (std::size_t k = first; across > 1 && k < first + static_cast<std::size_t>(parts) - 1; ++k)
                split_particle(points, half, k, 1, across);
        }
    }
    return points.size() > before;
}

/// CPDI-R4 that splits its particles.
class SplittingParallelograms : public Parallelograms<DomainR4, false> {
public:
    using Base = Parallelograms<DomainR4, false>;

    SplittingParallelograms() = default;
    /// Splits `points` at once where it must. Throws OutsideGrid.
    template <class Points>
    SplittingParallelograms(const Lattice<2>& lattice, Points& points, std::vector<Vec<2>> half) : lattice_(lattice) {
        split_long(points, half, lattice.h());
        static_cast<Base&>(*this) = Base(lattice, points, std::move(half));
    }
    template <class Body> void follow(Body& body, double dt) {
        std::vector<Vec<2>> halves = half();
        if (split_long(body.points, halves, lattice_.h())) static_cast<Base&>(*this) = Base(lattice_, body.points, std::move(halves));
        else Base::follow(body, dt);
    }

private:
    Lattice<2> lattice_;
};

}  // namespace mpm
