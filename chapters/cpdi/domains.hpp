/// The weighting function of a body whose particles have domains with a fixed number of corners (review 3.6, Algorithm 5).
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "chapters/cpdi/corners.hpp"
#include "chapters/cpdi/domain.hpp"
#include "chapters/cpdi/watch.hpp"

namespace mpm {

/// Particle i has the corners of[i], which neighbours share. Its stencil counts corners: the sweeps go from particles to corners and from
/// there to the grid. Corners move with the grid (3.38); those of a total-Lagrangian body stay where they start.
template <class DomainType, bool TotalLagrangian> class Domains {
public:
    using Domain = DomainType;
    static constexpr int D = Domain::D;
    static constexpr std::size_t N = Domain::corners;
    static constexpr bool total_lagrangian = TotalLagrangian;
    using Of = std::vector<std::array<int, N>>;

    Domains() = default;
    /// Throws OutsideGrid for a corner outside.
    Domains(const Lattice<D>& lattice, std::vector<Vec<D>> corners, Of of) : corners_(lattice, std::move(corners)), of_(std::move(of)) {}

    /// Function and gradient weights of particle i's corners, made anew for each sweep: storing them was slower with quadrilaterals.
    template <class Point> Stencil<D, N> operator()(const Point&, std::size_t i) const {
        const DomainWeights<D, N> w = Domain::weights(corners_of(i));
        Stencil<D, N> s;
        for (std::size_t c = 0; c < N; ++c) s[c] = {of_[i][c], w.f[c], w.g[c]};
        return s;
    }
    const Corners<D>& corners() const { return corners_; }
    std::size_t size() const { return of_.size(); }
    std::array<Vec<D>, N> corners_of(std::size_t i) const {
        std::array<Vec<D>, N> x;
        for (std::size_t c = 0; c < N; ++c) x[c] = corners_[of_[i][c]];
        return x;
    }

    /// Corners go with the velocity that strains their particles, so that these keep V = J V0; particles are where their domains are
    /// (3.39).
    template <class Body>
        requires(!TotalLagrangian)
    void follow(Body& body, double dt) {
        corners_.move(body.grid, dt);
        for (std::size_t i = 0; i < of_.size(); ++i) body.points[i].x = Domain::weights(corners_of(i)).centroid;
    }

    /// Domains that are no good any more (watch.hpp).
    template <class Body>
        requires(D == 2)
    Trouble trouble(const Body& body) const {
        return check_domains(*this, body.points, body.grid.lattice().h());
    }

private:
    Corners<D> corners_;
    Of of_;
};

}  // namespace mpm
