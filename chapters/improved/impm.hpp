/// iMPM, the improved MPM of Sulsky and Gong (review 5.5.2, Algorithm 10; line numbers in the margin): nodal velocities, and density and
/// stress in the cells, come from the particles by moving least squares; the weak form is integrated over cells. Lines 16 and 17 stand
/// here at the beginning of a step instead of the end of the one before. `gradient` "hat" is line 12 as printed, which ruins fine grids
/// (notes.md); "linear" mends it.
#pragma once
#include <memory>
#include <vector>

#include "chapters/explicit/point.hpp"
#include "chapters/improved/impm_cells.hpp"
#include "chapters/improved/impm_choice.hpp"
#include "chapters/improved/impm_gradient.hpp"
#include "chapters/improved/impm_watch.hpp"
#include "chapters/improved/mls.hpp"
#include "lab/body.hpp"

namespace mpm {

template <int Dim> struct Impm : ImpmChoice {
    static constexpr const char* name = "impm";
    template <int> using PointOf = Point<Dim>;
    template <int> using NodeOf = mpm::Node<Dim>;
    std::vector<ImpmCells<Dim>> cells = {};  // of each body
    std::shared_ptr<ImpmWatch> seen = std::make_shared<ImpmWatch>();

    template <class Bodies, class Coupling, class Scene>
    void step(Bodies& bodies, const Coupling& coupling, const Scene& scene, double t, double dt) {
        using Body = typename Bodies::value_type;
        using Node = typename Body::Node;
        constexpr int D = Body::D;
        cells.resize(bodies.size());
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            auto& body = bodies[b];
            const auto& near = cells[b].near;
            body.grid.reset();
            cells[b].find(body.grid.lattice(), body.points, surface == "whole", quadrature == "gauss");
            cells[b].each_sample(body.grid.threads(), [&](CellPoint<D>& c, const Vec<D>& x) {
                const auto rho_sigma = fitted<1 + D * D>(near, body.points, x, density_and_stress<Point<D>>);
                c.rho = rho_sigma[0];                                                     // 16
                c.sigma = Eigen::Map<const Mat<D>>(rho_sigma.data() + 1);                 // 17
            });
            in_ranges(body.grid.threads(), static_cast<std::size_t>(body.grid.size()), [&](std::size_t number) {
                const int I = static_cast<int>(number);
                Node& node = body.grid[I];
                cells[b].around(I, [&](const CellPoint<D>& c, double N, const Vec<D>& grad) {
                    node.m += N * c.rho * c.V;                                            // 2
                    node.f -= c.V * c.sigma * grad;                                       // 4
                });
                if (!(node.m > 0)) return;
                node.mv = node.m * fitted<D>(near, body.points, body.grid.lattice().position(I), [](const auto& p) { return p.v; });  // 3
            });
            seen->weigh(body);
            scene.load(body, t);                                                          // 5
            each(body.grid, [&](auto& node) { node.mv_new = node.mv + dt * node.f; });    // 7
            scene.fix(body.grid, &Node::mv, t);                                           // 8
            scene.fix(body.grid, &Node::mv_new, t + dt);
        }
        coupling(bodies, t, dt);
        for (auto& body : bodies) {
            const auto fix = [&](auto field) { scene.fix(body.grid, field, t + dt); };
            body.transfer.nodal_velocities(body, fix);
            gather(body, [&](auto& p, const auto& weights) {                              // 9
                Vec<D> v = Vec<D>::Zero();
                Mat<D> L = Mat<D>::Zero();
                for (const auto& [node, phi, grad] : weights) {
                    v += phi * node.v_new;
                    L += node.v_new * grad.transpose();                                   // 12, as printed
                }
                if (gradient == "linear") L = gradient_between_cells<D>(body.grid, p.x);  // 12, mended
                body.transfer.update_velocity(p, weights);                                // 10
                p.x += dt * body.transfer.moving(p, v);                                   // 11
                p.F += dt * L * p.F;                                                      // 13
                p.V = p.F.determinant() * p.V0;                                           // 14; the density of 15 is m/V
                body.law.update(p, L, dt);
            });
        }
    }

private:
    template <class P> static Eigen::Matrix<double, 1 + Dim * Dim, 1> density_and_stress(const P& p) {
        Eigen::Matrix<double, 1 + Dim * Dim, 1> u;
        u[0] = p.m / p.V;
        u.template tail<Dim * Dim>() = Eigen::Map<const Vec<Dim * Dim>>(p.sigma.data());
        return u;
    }
    /// Values at x by moving least squares. A place in a cell with particles that sees none within the support takes the weighted mean of
    /// those within two cells.
    template <int F, class Points, class Values>
    Eigen::Matrix<double, F, 1> fitted(const NearPoints<Dim>& near, const Points& points, const Vec<Dim>& x, Values&& values) const {
        const auto fit = mls_at<F>(mls, near, points, x, values);
        seen->see(fit.degree, mls);
        if (fit.degree >= 0) return fit.values;
        return mls_at<F>(MlsChoice{0, 2, mls.quartic}, near, points, x, values).values;
    }
};

}  // namespace mpm
