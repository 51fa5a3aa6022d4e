/// What the command line says of a contact: its law, its normals, its test of the gap.
#pragma once
#include <string>

#include "lab/options.hpp"

namespace mpm {

struct ContactChoice {
    enum class Law { none, frictionless, coulomb, bonded };
    enum class Normals { gradient, volume, density, regression };
    enum class Gap { velocity, position, extent };

    std::string contact = "coulomb", normals = "regression", gap = "extent", common = "on";
    double mu = 0.3;         // friction coefficient [-]
    double reach = 0.8;      // of the gap by positions: distance at which faces are taken to touch [cells]

    void declare(Options& o) {
        o.choice("contact", contact, {"none", "frictionless", "coulomb", "bonded"},
                 "none: bodies pass through each other; bonded: they stick, always");
        o.choice("normals", normals, {"gradient", "volume", "density", "regression"},
                 "from the gradient of mass (5.12), of volume, of the cells' density (5.11), or between the particles of both bodies");
        o.choice("common", common, {"on", "off"}, "one normal for each pair of bodies, or each body its own, as printed");
        o.choice("gap", gap, {"velocity", "position", "extent"},
                 "bodies touch where they approach; and where their extrapolated positions, or their particles' extents, meet");
        o.number("mu", mu, "-", at_least(0), "coefficient of friction, for --contact coulomb");
        o.number("reach", reach, "cells", above(0), "distance of extrapolated positions at which faces touch, for --gap position");
    }

    Law law() const {
        return contact == "none" ? Law::none : contact == "bonded" ? Law::bonded : contact == "coulomb" ? Law::coulomb : Law::frictionless;
    }
    Normals kind() const {
        if (normals == "gradient") return Normals::gradient;
        if (normals == "volume") return Normals::volume;
        return normals == "density" ? Normals::density : Normals::regression;
    }
    Gap test() const { return gap == "velocity" ? Gap::velocity : gap == "position" ? Gap::position : Gap::extent; }
    double friction() const { return law() == Law::coulomb ? mu : 0; }
    /// Normals by regression are the pair's own.
    bool collinear() const { return common == "on" || kind() == Normals::regression; }
};

}  // namespace mpm
