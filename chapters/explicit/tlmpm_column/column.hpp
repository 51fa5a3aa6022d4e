/// Joins the TLMPM with the column of one law and with the weighting function and transfer that the command line names.
#pragma once
#include "chapters/explicit/tlmpm_column/settings.hpp"
#include "chapters/improved/variants.hpp"
#include "chapters/scenes/column.hpp"

namespace mpm {

/// Line 29 of the report's Algorithm 1: particles move with their own velocity, x += dt v_p, not with the grid's, by which they are
/// strained. F and x then part company: 5 % of the displacement at the free end of ten cells. The rest of
/// Algorithm 1 is the page's, with the updated momenta in line 21, where it prints those before the update.
struct MovedByParticles : Flip {
    template <class Point, class Velocity> const Velocity& moving(const Point& p, const Velocity&) const { return p.v; }
};

template <class Law> Assembled tlmpm_column(const ColumnSettings& s, int cells) {
    const Column<Law> column(s.column);
    Assembled a;
    const auto assembled_with = [&](const auto& transfer) {
        ColumnShapes::with(s.common.shape,
                           [&](auto kernel) { a = assemble_with<decltype(kernel), true>(s.scheme, column, transfer, cells, s.common); });
    };
    if (s.position == "particle")
        assembled_with(MovedByParticles{{s.transfer.alpha}});
    else
        s.transfer.with<true>(assembled_with);
    a.row.scene += "-" + s.column.which;
    return a;
}

}  // namespace mpm
