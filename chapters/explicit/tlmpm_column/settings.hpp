/// What the command line of tlmpm_column says.
#pragma once
#include <string>

#include "chapters/explicit/tlmpm.hpp"
#include "chapters/improved/transfers.hpp"
#include "chapters/scenes/column_cases.hpp"
#include "chapters/weighting/shapes.hpp"
#include "lab/program.hpp"

namespace mpm {

/// Order 1 and 2 of the report's equation 28 (hat, lagrange), and the others that suit total-Lagrangian schemes.
using ColumnShapes = ShapeList<Hat, Lagrange2, Ugimp, Cpgimp, Quadratic, Cubic, Bernstein>;

struct ColumnSettings {
    ColumnCase column;
    Common common;
    TransferChoice transfer;
    Tlmpm scheme;
    std::string position = "grid";
};

/// One function for each law, each in a translation unit of its own.
Assembled neo_hookean_column(const ColumnSettings& settings, int cells);
Assembled hooke_column(const ColumnSettings& settings, int cells);

}  // namespace mpm
