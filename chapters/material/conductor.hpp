/// Fourier's law of heat conduction (review 5.19) with a specific heat and a uniform source.
#pragma once
#include "lab/math.hpp"

namespace mpm {

/// q = -k grad T. Any consistent units.
struct Conductor {
    static constexpr const char* name = "fourier";
    double k = 1, c = 1, rho = 1;  // conductivity [power/(length temperature)], specific heat [energy/(mass temperature)], density
    double source = 0;             // heat produced per volume and time (gamma* of 5.18)

    double diffusivity() const { return k / (rho * c); }  // [length^2/time]
    template <class Gradient> Gradient flux(const Gradient& grad_T) const { return -k * grad_T; }
    /// Heat of a particle, counted from a temperature.
    template <class Point> double heat(const Point& p, double from) const { return p.m * c * (p.T - from); }
};

}  // namespace mpm
