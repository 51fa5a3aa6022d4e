/// The weighting functions of review 3.2 to 3.5 by name, for `--shape`. A new one is a header and an entry here.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "chapters/weighting/bernstein.hpp"
#include "chapters/weighting/cpgimp.hpp"
#include "chapters/weighting/cubic.hpp"
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/lagrange.hpp"
#include "chapters/weighting/quadratic.hpp"
#include "chapters/weighting/ugimp.hpp"

namespace mpm {

template <class... Kernels> struct ShapeList {
    static std::vector<std::string> names() { return {Kernels::name...}; }

    /// Calls visit(Kernel{}) for the kernel of that name; false if there is none.
    template <class Visit> static bool with(const std::string& name, Visit&& visit) {
        return ((name == Kernels::name && (static_cast<void>(visit(Kernels{})), true)) || ...);
    }
};

using AllShapes = ShapeList<Hat, Ugimp, Cpgimp, Quadratic, Cubic, Bernstein>;

/// Those fit for updated-Lagrangian schemes: the review keeps Bernstein functions to total-Lagrangian ones.
using UpdatedShapes = ShapeList<Hat, Ugimp, Cpgimp, Quadratic, Cubic>;

/// Those of finite elements. Lagrange functions are not among all: with one particle per cell they leave nodes without mass.
using ElementShapes = ShapeList<Hat, Lagrange2>;

/// Gives a kernel its initial particle size, where it has one.
template <class Kernel> Kernel sized(int ppc) {
    Kernel kernel{};
    if constexpr (requires { kernel.l = 1.0; }) kernel.l = 1.0 / ppc;
    if constexpr (requires { kernel.l0 = 1.0; }) kernel.l0 = 1.0 / ppc;
    return kernel;
}

}  // namespace mpm
