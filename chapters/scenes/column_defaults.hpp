/// The numerical parameters that the report gives with its three cases, as defaults of the programs that run them.
#pragma once
#include <cmath>

#include "chapters/material/hooke.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/column.hpp"
#include "lab/program.hpp"

namespace mpm {

/// Its time steps are 0.1 and 0.2 h/sqrt(E/rho), here as fractions of h/(c_P + |v|) with the P-wave speed under the full load.
inline void set_defaults(Common& common, const ColumnCase& c) {
    const double wave = c.law == Hooke::name ? Column<Hooke>(c).wave_speed() : Column<NeoHookean>(c).wave_speed();
    common.cells = {c.which == "A" ? 10 : 32};
    common.ppc = c.which == "C" ? 3 : 2;
    common.shape = c.which == "A" ? "hat" : "lagrange";
    common.t_end = c.which == "A" ? 1.2 : 0.2;
    common.cfl = (c.which == "C" ? 0.2 : 0.1) * (wave + c.largest_v0()) / std::sqrt(c.E / c.rho);
}

}  // namespace mpm
