/// What can be chosen of the improved MPM (impm.hpp), and that on the command line.
#pragma once
#include <string>

#include "chapters/improved/mls.hpp"
#include "lab/options.hpp"

namespace mpm {

struct ImpmChoice {
    MlsChoice mls = {1, 1.1, false, 12};  // of velocities, densities and stresses alike
    std::string gradient = "linear";      // at particles: linear between cells, or that of the hat functions
    std::string quadrature = "centre";    // one point in each cell, or 2^D Gauss points
    std::string surface = "part";         // cells at a surface hold as much as their particles do, or are whole
};

struct ImpmOptions : ImpmChoice {
    std::string basis = "linear", weight = "cubic";

    /// `of` stands before the help's text, e.g. "of --scheme impm: ".
    void declare(Options& o, int dim, const std::string& of = "") {
        o.choice("gradient", gradient, {"linear", "hat"}, of + "velocity gradient at particles: linear between cells, or as printed");
        o.number("support", mls.support, "cells", between(0.6, 10), of + "radius of the particles that a fit sees");
        o.choice("basis", basis, {"shepard", "linear", "quadratic"}, of + "polynomials of the moving least squares");
        o.choice("weight", weight, {"cubic", "quartic"}, of + "spline that weighs the particles (D.6, D.7)");
        o.number("limit", mls.limit, "-", at_least(1), of + "square of a fit's largest amplification of noise; 1 is that of a mean");
        o.choice("surface", surface, {"part", "whole"}, of + "cells at a surface hold as much as their particles do, or are whole");
        if (dim == 2)
            o.choice("quadrature", quadrature, {"centre", "gauss"}, of + "one point in the middle of a cell, or 2 x 2 Gauss points");
    }
    /// The name of an option that is not at its default, or "", to refuse it where it means nothing.
    std::string changed() const {
        const ImpmOptions usual;
        if (gradient != usual.gradient) return "gradient";
        if (mls.support != usual.mls.support) return "support";
        if (basis != usual.basis) return "basis";
        if (weight != usual.weight) return "weight";
        if (mls.limit != usual.mls.limit) return "limit";
        if (surface != usual.surface) return "surface";
        return quadrature != usual.quadrature ? "quadrature" : "";
    }

    ImpmChoice choice() const {
        ImpmChoice c = *this;
        c.mls.degree = basis == "shepard" ? 0 : basis == "linear" ? 1 : 2;
        c.mls.quartic = weight == "quartic";
        return c;
    }
};

}  // namespace mpm
