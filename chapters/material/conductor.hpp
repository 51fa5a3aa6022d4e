/// Fourier's law of heat conduction (review 5.19) with a specific heat and a uniform source, alone or beside a mechanical law.
#pragma once
#include <array>
#include <cstddef>

#include "lab/math.hpp"

namespace mpm {

/// q = -k grad T. Any consistent units.
struct Fourier {
    double k = 1, c = 1;  // conductivity [power/(length temperature)], specific heat [energy/(mass temperature)]
    double source = 0;    // heat produced per volume and time (gamma* of 5.18)

    template <class Gradient> Gradient flux(const Gradient& grad_T) const { return -k * grad_T; }
    /// Heat of a particle, counted from a temperature.
    template <class Point> double heat(const Point& p, double from) const { return p.m * c * (p.T - from); }
};

/// A body that conducts heat and does nothing else.
struct Conductor : Fourier {
    static constexpr const char* name = "fourier";
    double rho = 1;  // density

    double diffusivity() const { return k / (rho * c); }  // [length^2/time]
};

/// A solid that conducts heat; its particles have a temperature T beside what the solid's have.
template <class Solid> struct Conducting : Solid, Fourier {
    double diffusivity() const { return k / (Solid::rho * c); }

    /// Further columns of snapshots: the solid's and the temperature.
    static constexpr std::size_t own = [] {
        if constexpr (requires { Solid::columns; }) return Solid::columns.size();
        return std::size_t{0};
    }();
    static constexpr auto columns = [] {
        std::array<const char*, own + 1> all{};
        if constexpr (own > 0)
            for (std::size_t i = 0; i < own; ++i) all[i] = Solid::columns[i];
        all[own] = "T";
        return all;
    }();
    template <class Point> std::array<double, own + 1> values(const Point& p) const {
        std::array<double, own + 1> all{};
        if constexpr (own > 0) {
            const auto of_solid = Solid::values(p);
            for (std::size_t i = 0; i < own; ++i) all[i] = of_solid[i];
        }
        all[own] = p.T;
        return all;
    }
};

}  // namespace mpm
