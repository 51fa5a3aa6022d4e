/// A thin inextensible ring pressed between two flat plates: the elastica, for displacements of any size.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace mpm {

/// Force against displacement, by integration of the elastica along a quarter from the contact to the side. The arc's tangent turns from 0
/// to pi/2, and in units of the radius R and of E'I/R^2 its curvature k grows as dk/ds = F/2 cos(theta). Plates touch in a point until the
/// curvature there has fallen to zero, at a displacement of 0.564 R; then a part of length a lies flat, and the force acts at its ends.
class ElasticaRing {
public:
    ElasticaRing() {
        states_.push_back({0, 0});
        for (int i = 1; i < points; ++i) states_.push_back(touching(1 - static_cast<double>(i) / (points - 1)));
        for (int i = 1; i < points; ++i) states_.push_back(flattened(longest * i / (points - 1)));
    }

    /// Force in E'I/R^2 at a displacement in R, both of the whole ring; linear between computed states, nan beyond the last (1.66 R).
    double force(double displacement) const {
        const auto above = std::find_if(states_.begin() + 1, states_.end(), [&](const State& s) { return s.displacement >= displacement; });
        if (above == states_.end() || !(displacement >= 0)) return std::nan("");
        const State &b = *above, &a = *(above - 1);
        return a.force + (b.force - a.force) * (displacement - a.displacement) / (b.displacement - a.displacement);
    }

    struct State {
        double displacement, force;  // [R], [E'I/R^2]
    };
    const std::vector<State>& states() const { return states_; }

private:
    static constexpr int points = 41;
    static constexpr double longest = 1.2;  // flat part of a quarter, of pi/2 [R]

    struct Side {
        double theta, height;  // of the arc's end: angle of its tangent, height from the contact
    };
    /// Runge and Kutta's fourth order from curvature k at the contact.
    static Side arc(double length, double k, double F) {
        using Y = std::array<double, 3>;  // theta, k, height
        constexpr int n = 64;  // 1e-8 of the force
        const double h = length / n;
        const auto rate = [&](const Y& y) { return Y{y[1], F / 2 * std::cos(y[0]), std::sin(y[0])}; };
        const auto ahead = [](const Y& y, double step, const Y& r) {
            return Y{y[0] + step * r[0], y[1] + step * r[1], y[2] + step * r[2]};
        };
        Y y{0, k, 0};
        for (int i = 0; i < n; ++i) {
            const Y a = rate(y), b = rate(ahead(y, h / 2, a)), c = rate(ahead(y, h / 2, b)), d = rate(ahead(y, h, c));
            for (std::size_t j = 0; j < y.size(); ++j) y[j] += h / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
        }
        return {y[0], y[2]};
    }
    /// The force that turns the arc's tangent upright, by bisection; it turns further the larger the force.
    static State upright(double length, double k) {
        double low = 0, high = 1;
        while (arc(length, k, high).theta < std::numbers::pi / 2) high *= 2;
        for (int i = 0; i < 50; ++i) {
            const double F = 0.5 * (low + high);
            (arc(length, k, F).theta < std::numbers::pi / 2 ? low : high) = F;
        }
        return {2 - 2 * arc(length, k, high).height, high};
    }
    static State touching(double k) { return upright(std::numbers::pi / 2, k); }
    static State flattened(double a) { return upright(std::numbers::pi / 2 - a, 0); }

    std::vector<State> states_;
};

}  // namespace mpm
