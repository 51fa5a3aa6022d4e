/// Joins the TLMPM with the column of one law and with the weighting function and transfer that the command line names.
#pragma once
#include <cstddef>
#include <vector>

#include "chapters/explicit/tlmpm_column/settings.hpp"
#include "chapters/scenes/column.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/assemble.hpp"

namespace mpm {

/// Line 29 of the report's Algorithm 1: particles move with their own velocity, x += dt v_p, not with the grid's, by which they are strained. F and x
/// then part company: 5 % of the displacement at the free end of ten cells.
struct MovedByParticles : Flip {
    template <class Point, class Velocity> const Velocity& moving(const Point& p, const Velocity&) const { return p.v; }
};

/// Weights at the initial positions that have forgotten their function: a step is compiled for each size of stencil, not for each function.
template <int Support, int PerCell> class Kept {
public:
    struct Kernel {
        static constexpr const char* name = "";  // told by --shape
        static constexpr int per_cell = PerCell;
    };
    static constexpr bool total_lagrangian = true;
    template <class Shape, class Points> Kept(const Shape& shape, const Points& points) {
        for (const auto& p : points) stencils_.push_back(shape.at(p.X, p));
    }
    template <class Point> const auto& operator()(const Point&, std::size_t i) const { return stencils_[i]; }

private:
    std::vector<Stencil<1, Support>> stencils_;
};

template <class Law> Assembled tlmpm_column(const ColumnSettings& s, int cells) {
    const Column<Law> column(s.column);
    Assembled a;
    const auto assembled_with = [&](const auto& transfer) {
        ColumnShapes::with(s.common.shape, [&](auto kernel) {
            using Kernel = decltype(kernel);
            using Shape = Kept<Kernel::support, Kernel::per_cell>;
            a = assemble<Shape>(s.scheme, column, transfer, cells, s.common, [&](const auto& lattice, const auto& points) {
                return Shape(Tensor<1, Kernel>{lattice, sized<Kernel>(s.common.ppc)}, points);
            });
        });
    };
    if (s.position == "particle") assembled_with(MovedByParticles{{s.transfer.alpha}});
    else s.transfer.with<true>(assembled_with);
    a.row.shape = s.common.shape;
    a.row.scene += "-" + s.column.which;
    return a;
}

}  // namespace mpm
