/// A small bar or square for the tests of the schemes, any scheme and shape, without files or options.
#pragma once
#include <cmath>
#include <type_traits>
#include <vector>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/explicit/usf.hpp"
#include "chapters/explicit/usl.hpp"
#include "chapters/material/linear_elastic.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/boundary.hpp"
#include "lab/monitor.hpp"

namespace mpm::test {

template <int D, class Scheme, class Law, class Kernel = Hat, class Transfer = Flip> struct Problem {
    static constexpr bool total = std::is_same_v<Scheme, Tlmpm>;
    using Moving = Tensor<D, Kernel>;
    using Shape = std::conditional_t<total, Stored<Moving>, Moving>;
    using Point = typename Transfer::template PointOf<typename WithHistory<Law, mpm::Point<D>>::Point>;
    using Node = typename Transfer::template NodeOf<typename Scheme::template NodeOf<D>>;
    using BodyType = Body<D, Point, Node, Law, Shape, Transfer>;

    Scheme scheme{};
    Transfer transfer{};
    Lattice<D> lattice;
    std::vector<BodyType> bodies;
    Dirichlet held;
    double t = 0;

    template <class B> void load(B&, double) const {}
    template <class G, class Field> void fix(G& grid, Field field, double) const { held.apply(grid, field); }

    /// A body of cells^D cells of size h with ppc^D particles each, its corner at `corner` cells of a grid of `grid_cells` cells.
    void add(const Law& law, int cells, int ppc, int corner, int grid_cells, double h, const Vec<D>& shift = Vec<D>::Zero()) {
        std::array<int, D> all;
        all.fill(grid_cells);
        lattice = Lattice<D>(shift, Vec<D>::Constant(h), all, Kernel::per_cell);
        std::vector<Point> points;
        const int n = cells * ppc;
        for (int j = 0; j < (D == 2 ? n : 1); ++j)
            for (int i = 0; i < n; ++i) {
                Point p;
                p.x[0] = corner * h + (i + 0.5) * h / ppc;
                if constexpr (D == 2) p.x[1] = corner * h + (j + 0.5) * h / ppc;
                p.x += shift;
                p.X = p.x;
                p.V = p.V0 = std::pow(h / ppc, D);
                p.m = law.rho * p.V0;
                points.push_back(p);
            }
        add_points(law, points, ppc);
    }
    void add_points(const Law& law, const std::vector<Point>& points, int ppc) {
        Kernel kernel{};
        if constexpr (requires { kernel.l = 1.0; }) kernel.l = 1.0 / ppc;
        if constexpr (requires { kernel.l0 = 1.0; }) kernel.l0 = 1.0 / ppc;
        const Moving moving{lattice, kernel};
        if constexpr (total)
            bodies.push_back(BodyType{{points, Grid<D, Node>(lattice), law}, Shape(moving, points), transfer});
        else
            bodies.push_back(BodyType{{points, Grid<D, Node>(lattice), law}, moving, transfer});
    }
    std::vector<Point>& points() { return bodies[0].points; }
    void run(int steps, double dt) {
        for (int k = 0; k < steps; ++k, t += dt) scheme.step(bodies, Free{}, *this, t, dt);
    }
    Vec<D> momentum() const {
        Vec<D> mv = Vec<D>::Zero();
        for (const auto& body : bodies)
            for (const auto& p : body.points) mv += p.m * p.v;
        return mv;
    }
};

}  // namespace mpm::test
