/// Plastic work that turns into heat where it is done (review B.13).
#pragma once

namespace mpm {

/// dT = chi dW/(m c) for a conducting solid whose particles count their plastic work: sigma_f d(eps_p)/(rho c) with the density of now.
template <class Solid> struct PlasticHeating : Solid {
    double chi = 0.9;  // part of the plastic work that becomes heat (Taylor and Quinney) [-]

    template <class Point, class Gradient> void update(Point& p, const Gradient& L, double dt) const {
        const double before = p.plastic_work;
        Solid::update(p, L, dt);
        p.T += chi * (p.plastic_work - before) / (p.m * Solid::c);
    }
};

}  // namespace mpm
