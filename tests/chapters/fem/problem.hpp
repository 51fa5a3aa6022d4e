/// A mesh of elements for the tests of the finite elements and of the TLMPM at their Gauss points, without files or options.
#pragma once
#include <random>
#include <vector>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/fem/total.hpp"
#include "chapters/fem/updated.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/assemble.hpp"
#include "lab/fill.hpp"

namespace mpm::test {

const NeoHookean soft{30, 20, 1};  // in any units: wave speed 8.4

/// The transfer that a scheme gets where none is told: finite elements have none.
template <class Scheme> using TransferOf = std::conditional_t<std::is_same_v<Scheme, Tlmpm>, Flip, NoTransfer>;

/// A line or square of `cells` elements of size h along each axis with `gauss` points along each.
template <int D, class Scheme, class Kernel = Hat, class Transfer = TransferOf<Scheme>, class Law = NeoHookean> struct Mesh {
    using Shape = Stored<Tensor<D, Kernel>>;
    using P = PointFor<Scheme, Law, Transfer, D>;
    using N = NodeFor<Scheme, Transfer, D>;
    using OneBody = Body<D, P, N, Law, Shape, Transfer>;

    Scheme scheme{};
    std::vector<OneBody> bodies;
    double t = 0;

    Mesh(int cells, int gauss, double h, const Law& law = soft, const Scheme& s = {}, const Transfer& transfer = {}) : scheme(s) {
        std::array<int, D> all;
        all.fill(cells);
        const Lattice<D> lattice(Vec<D>::Zero(), Vec<D>::Constant(h), all, Kernel::per_cell);
        const CellRule rule = gauss_points(gauss);
        std::vector<P> points;
        const int n = cells * gauss;
        for (int j = 0; j < (D == 2 ? n : 1); ++j)
            for (int i = 0; i < n; ++i) {
                P& p = points.emplace_back();
                p.V0 = 1;
                const std::array<int, 2> along{i, j};
                for (int d = 0; d < D; ++d) {
                    const int k = along[static_cast<std::size_t>(d)];
                    p.X[d] = (k / gauss + rule.at[static_cast<std::size_t>(k % gauss)]) * h;
                    p.V0 *= rule.part[static_cast<std::size_t>(k % gauss)] * h;
                }
                p.x = p.X;
                p.V = p.V0;
                p.m = law.rho * p.V0;
            }
        Shape shape(Tensor<D, Kernel>{lattice}, points);
        bodies.push_back(OneBody{{std::move(points), Grid<D, N>(lattice), law}, std::move(shape), transfer});
    }
    auto& body() { return bodies[0]; }
    auto& points() { return bodies[0].points; }
    auto& grid() { return bodies[0].grid; }

    /// Starts with the velocities of a scene, and steps.
    template <class Scene> void start(const Scene& scene) { scheme.start(bodies, scene); }
    template <class Scene> void run(const Scene& scene, int steps, double dt) {
        for (int k = 0; k < steps; ++k, t += dt) scheme.step(bodies, Free{}, scene, t, dt);
    }
};

/// Every point gets a random deformation, of up to 20 % along each axis, and the stress that belongs to it.
template <class Mesh> void deform(Mesh& mesh, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-0.2, 0.2);
    for (auto& p : mesh.points()) {
        for (int i = 0; i < p.F.size(); ++i) p.F.data()[i] += part(random);
        p.V = p.F.determinant() * p.V0;
        mesh.body().law.update(p, p.F, 0);
    }
}

/// Nothing held, no load, a velocity field.
template <int D> struct Thrown : FreeScene {
    Mat<D> A = Mat<D>::Zero();
    Vec<D> a = Vec<D>::Zero();
    double wave = 0;  // of a rough part of the field
    Vec<D> initial_velocity(const Vec<D>& X) const { return A * X + a + wave * Vec<D>((7 * X).array().sin()); }
};

}  // namespace mpm::test
