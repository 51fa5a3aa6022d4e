/// Plane regions as small values, and what is made of them: `disk - box`, `a | b`, `a & b`. Any type with `bool inside(x)` and `Bounds
/// bounds()` is a region. Lengths in any consistent units.
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "lab/math.hpp"

namespace mpm {

/// A rectangle that holds a region [length]; infinite along what the region does not bound, low > high where it is empty.
struct Bounds {
    static constexpr double inf = std::numeric_limits<double>::infinity();
    Vec<2> low = Vec<2>::Constant(-inf), high = Vec<2>::Constant(inf);
};
inline Bounds both(const Bounds& a, const Bounds& b) { return {a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)}; }
inline Bounds around(const Bounds& a, const Bounds& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

template <class R>
concept Region = requires(const R& region, const Vec<2>& x) {
    { region.inside(x) } -> std::convertible_to<bool>;
    { region.bounds() } -> std::same_as<Bounds>;
};
/// A region that knows the area it shares with a rectangle [length^2].
template <class R>
concept OverlapRegion = Region<R> && requires(const R& region, const Bounds& box) {
    { region.overlap(box) } -> std::same_as<double>;
};

/// Corners `low`, `high`; its edges belong to it.
struct Box {
    Vec<2> low = Vec<2>::Zero(), high = Vec<2>::Ones();

    bool inside(const Vec<2>& x) const { return (x.array() >= low.array()).all() && (x.array() <= high.array()).all(); }
    Bounds bounds() const { return {low, high}; }
    double area() const { return (high - low).prod(); }
    double perimeter() const { return 2 * (high - low).sum(); }
    double overlap(const Bounds& box) const { return (box.high.cwiseMin(high) - box.low.cwiseMax(low)).cwiseMax(0).prod(); }
};

/// Centre and radius; its circle belongs to it.
struct Disk {
    Vec<2> centre = Vec<2>::Zero();
    double r = 1;

    bool inside(const Vec<2>& x) const { return (x - centre).squaredNorm() <= r * r; }
    Bounds bounds() const { return {centre - Vec<2>::Constant(r), centre + Vec<2>::Constant(r)}; }
    double area() const { return std::numbers::pi * r * r; }
    double perimeter() const { return 2 * std::numbers::pi * r; }
    double overlap(const Bounds& box) const {
        const Vec<2> a = (box.low - centre) / r, b = (box.high - centre) / r;
        if (a.cwiseAbs().cwiseMax(b.cwiseAbs()).norm() <= 1) return (box.high - box.low).prod();
        if (a.cwiseMax(0).cwiseMax(-b).norm() >= 1) return 0;  // its nearest point is outside
        return r * r * std::max(0.0, below(b[0], b[1]) - below(a[0], b[1]) - below(b[0], a[1]) + below(a[0], a[1]));
    }

private:
    /// Part of the unit disk to the left of x.
    static double left(double x) { return x * std::sqrt(1 - x * x) + std::asin(x) + std::numbers::pi / 2; }
    /// Part of the unit disk to the left of x and below y: a sector and two triangles where the corner lies in it.
    static double below(double x, double y) {
        x = std::clamp(x, -1.0, 1.0);
        y = std::clamp(y, -1.0, 1.0);
        if (x * x + y * y < 1) return x * y + (left(x) + left(y)) / 2 - std::numbers::pi / 4;
        if (x > 0 && y > 0) return left(x) + left(y) - std::numbers::pi;
        return x <= 0 && y <= 0 ? 0 : left(std::min(x, y));
    }
};

/// Between two circles about one centre; both belong to it.
struct Ring {
    Vec<2> centre = Vec<2>::Zero();
    double inner = 0.5, outer = 1;

    bool inside(const Vec<2>& x) const {
        const double rr = (x - centre).squaredNorm();
        return rr >= inner * inner && rr <= outer * outer;
    }
    Bounds bounds() const { return Disk{centre, outer}.bounds(); }
    double area() const { return std::numbers::pi * (outer - inner) * (outer + inner); }
    double perimeter() const { return 2 * std::numbers::pi * (outer + inner); }
    double overlap(const Bounds& box) const {
        return std::max(0.0, Disk{centre, outer}.overlap(box) - (inner > 0 ? Disk{centre, inner}.overlap(box) : 0));
    }
};

/// The side of a line away from its normal: (x - at).normal <= 0. The normal need not have length one.
struct HalfPlane {
    Vec<2> at = Vec<2>::Zero(), normal = Vec<2>(0, 1);

    bool inside(const Vec<2>& x) const { return (x - at).dot(normal) <= 0; }
    Bounds bounds() const {
        Bounds b;
        for (const int d : {0, 1}) {
            if (normal[1 - d] != 0) continue;  // only a line along the other axis bounds this one
            (normal[d] > 0 ? b.high : b.low)[d] = at[d];
        }
        return b;
    }
};

template <Region A, Region B> struct Union {
    A a;
    B b;
    bool inside(const Vec<2>& x) const { return a.inside(x) || b.inside(x); }
    Bounds bounds() const { return around(a.bounds(), b.bounds()); }
};
template <Region A, Region B> struct Intersection {
    A a;
    B b;
    bool inside(const Vec<2>& x) const { return a.inside(x) && b.inside(x); }
    Bounds bounds() const { return both(a.bounds(), b.bounds()); }
};
/// a without b; what bounds b does not belong to it.
template <Region A, Region B> struct Difference {
    A a;
    B b;
    bool inside(const Vec<2>& x) const { return a.inside(x) && !b.inside(x); }
    Bounds bounds() const { return a.bounds(); }
};
template <Region A, Region B> Union<A, B> operator|(const A& a, const B& b) { return {a, b}; }
template <Region A, Region B> Intersection<A, B> operator&(const A& a, const B& b) { return {a, b}; }
template <Region A, Region B> Difference<A, B> operator-(const A& a, const B& b) { return {a, b}; }

}  // namespace mpm
