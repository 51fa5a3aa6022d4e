/// Several materials of one kind in one body: every particle names its own. They share the grid, and so they stick together.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lab/body.hpp"

namespace mpm {

/// The law of particle p is of[p.material].
template <class One> struct Materials {
    static constexpr const char* name = One::name;
    template <class Base> struct PointOf : WithHistory<One, Base>::Point {
        int material = 0;  // number of its law
    };
    std::vector<One> of;

    static constexpr std::size_t own = [] {  // columns of its laws
        if constexpr (requires { One::columns; }) return One::columns.size();
        return std::size_t{0};
    }();

    double wave_speed() const {
        double fastest = 0;
        for (const One& law : of) fastest = std::max(fastest, law.wave_speed());
        return fastest;
    }
    template <class Point> const One& law(const Point& p) const { return of[static_cast<std::size_t>(p.material)]; }
    template <class Point, class Gradient> void update(Point& p, const Gradient& L, double dt) const { law(p).update(p, L, dt); }
    template <class Point> double energy(const Point& p) const { return law(p).energy(p); }
    template <class Point>
        requires requires(const One& one, const Point& p) { one.sigma_zz(p); }
    double sigma_zz(const Point& p) const {
        return law(p).sigma_zz(p);
    }
    template <class Point>
        requires requires(const One& one, const Point& p) { one.dissipated(p); }
    double dissipated(const Point& p) const {
        return law(p).dissipated(p);
    }

    /// Further columns of snapshots: those of its laws.
    static constexpr auto columns = [] {
        if constexpr (own > 0) return One::columns;
        else return std::array<const char*, 0>{};
    }();
    template <class Point> std::array<double, own> values(const Point& p) const {
        if constexpr (own > 0) return law(p).values(p);
        else return {};
    }
};

}  // namespace mpm
