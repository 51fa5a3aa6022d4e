/// The weighting function of a body whose domains are polygons of 3 to 10 corners, mixed (review 3.6.6).
#pragma once
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "chapters/cpdi/corners.hpp"
#include "chapters/cpdi/polygon.hpp"
#include "chapters/cpdi/watch.hpp"

namespace mpm {

/// A stencil of at most `Most` entries.
template <int D, std::size_t Most> class BoundedStencil {
public:
    using value_type = StencilEntry<D>;
    void push_back(const value_type& entry) { entries_[size_++] = entry; }
    const value_type* data() const { return entries_.data(); }
    std::size_t size() const { return size_; }
    const value_type* begin() const { return data(); }
    const value_type* end() const { return data() + size_; }

private:
    std::array<value_type, Most> entries_;
    std::size_t size_ = 0;
};

/// Particle i has the corners of[i], counter-clockwise; one with more than three has an inner point too, at its centroid, which counts as
/// one more corner that nobody shares.
template <bool TotalLagrangian> class Polygons {
public:
    using Domain = DomainPolygon;
    static constexpr int D = 2;
    static constexpr std::size_t most = 10;
    static constexpr bool total_lagrangian = TotalLagrangian;
    using Of = std::vector<std::vector<int>>;

    Polygons() = default;
    /// Throws OutsideGrid for a corner outside, std::invalid_argument for a polygon with too few or too many corners.
    Polygons(const Lattice<2>& lattice, std::vector<Vec<2>> corners, const Of& of) : first_{0} {
        for (const std::vector<int>& polygon : of) {
            if (polygon.size() < 3 || polygon.size() > most)
                throw std::invalid_argument("a domain with " + std::to_string(polygon.size()) + " corners: 3 to 10 are allowed");
            pool_.insert(pool_.end(), polygon.begin(), polygon.end());
            first_.push_back(pool_.size());
        }
        for (std::size_t i = 0; i < of.size(); ++i) {
            inner_of_.push_back(static_cast<int>(corners.size()));
            const auto corner = [&](std::size_t c) { return corners[static_cast<std::size_t>(of[i][c])]; };
            if (count(i) > 3) corners.push_back(DomainPolygon::size(count(i), corner).centroid);
        }
        corners_ = Corners<2>(lattice, std::move(corners));
    }

    template <class Point> BoundedStencil<2, most + 1> operator()(const Point&, std::size_t i) const {
        BoundedStencil<2, most + 1> s;
        const std::size_t n = count(i);
        DomainPolygon::weights(n, corner(i), [&](std::size_t c, double f, const Vec<2>& g) { s.push_back({pool_[first_[i] + c], f, g}); });
        if (n > 3) s.push_back({inner_of_[i], DomainPolygon::inner_weight(n), Vec<2>::Zero()});
        return s;
    }
    const Corners<2>& corners() const { return corners_; }
    std::size_t size() const { return inner_of_.size(); }
    std::vector<Vec<2>> corners_of(std::size_t i) const {
        std::vector<Vec<2>> x;
        for (std::size_t c = 0; c < count(i); ++c) x.push_back(corner(i)(c));
        return x;
    }

    /// As Domains::follow.
    template <class Body>
        requires(!TotalLagrangian)
    void follow(Body& body, double dt) {
        corners_.move(body.grid, dt);
        for (std::size_t i = 0; i < size(); ++i) {
            body.points[i].x = DomainPolygon::size(count(i), corner(i)).centroid;
            if (count(i) > 3) corners_.place(static_cast<std::size_t>(inner_of_[i])) = body.points[i].x;
        }
        corners_.check();
    }

    /// Domains that are no good any more (watch.hpp).
    template <class Body> Trouble trouble(const Body& body) const { return check_domains(*this, body.points, body.grid.lattice().h()); }

private:
    std::size_t count(std::size_t i) const { return first_[i + 1] - first_[i]; }
    auto corner(std::size_t i) const {
        return [this, i](std::size_t c) -> const Vec<2>& { return corners_[pool_[first_[i] + c]]; };
    }

    Corners<2> corners_;
    std::vector<std::size_t> first_;  // where polygon i's corners start in the pool
    std::vector<int> pool_, inner_of_;
};

}  // namespace mpm
