/// The weighting function of a body whose domains F carries along: CPDI-R4, and CPDI-L2 with its corners at x -+ F l0/2 (review 3.6.1,
/// 3.6.2).
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "chapters/cpdi/corners.hpp"
#include "chapters/cpdi/domain.hpp"
#include "chapters/cpdi/watch.hpp"

namespace mpm {

/// Corners of particle i: N i to N i + N - 1, shared with nobody. `half` holds half the edges of its domain at the start.
template <class DomainType, bool TotalLagrangian> class Parallelograms {
public:
    using Domain = DomainType;
    static constexpr int D = Domain::D;
    static constexpr std::size_t N = Domain::corners;
    static constexpr bool total_lagrangian = TotalLagrangian;

    Parallelograms() = default;
    /// Throws OutsideGrid for a corner outside.
    template <class Points>
    Parallelograms(const Lattice<D>& lattice, const Points& points, std::vector<Vec<D>> half) : half_(std::move(half)) {
        std::vector<Vec<D>> corners;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (const Vec<D>& x : Domain::corners_of(points[i], half_[i])) corners.push_back(x);
        corners_ = Corners<D>(lattice, std::move(corners));
    }

    template <class Point> Stencil<D, N> operator()(const Point&, std::size_t i) const {
        const DomainWeights<D, N> w = Domain::weights(corners_of(i));
        Stencil<D, N> s;
        for (std::size_t c = 0; c < N; ++c) s[c] = {static_cast<int>(N * i + c), w.f[c], w.g[c]};
        return s;
    }
    const Corners<D>& corners() const { return corners_; }
    std::size_t size() const { return half_.size(); }
    std::array<Vec<D>, N> corners_of(std::size_t i) const {
        std::array<Vec<D>, N> x;
        for (std::size_t c = 0; c < N; ++c) x[c] = corners_[N * i + c];
        return x;
    }

    template <class Body>
        requires(!TotalLagrangian)
    void follow(Body& body, double) {
        for (std::size_t i = 0; i < half_.size(); ++i) {
            const auto x = Domain::corners_of(body.points[i], half_[i]);
            for (std::size_t c = 0; c < N; ++c) corners_.place(N * i + c) = x[c];
        }
        corners_.check();
    }

    /// Domains that are no good any more (watch.hpp).
    template <class Body>
        requires(D == 2)
    Trouble trouble(const Body& body) const {
        return check_domains(*this, body.points, body.grid.lattice().h());
    }

    const std::vector<Vec<D>>& half() const { return half_; }

private:
    Corners<D> corners_;
    std::vector<Vec<D>> half_;
};

}  // namespace mpm
