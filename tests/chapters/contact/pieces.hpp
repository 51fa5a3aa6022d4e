/// Small bodies for the tests of contact, with hat functions, without files or options.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "chapters/contact/bardenhagen.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/point.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/boundary.hpp"
#include "lab/fill.hpp"

namespace mpm::test {

inline constexpr double h = 0.1;

/// Nodes that every scheme's own extend: MUSL's has one field more.
template <class Scheme> struct Pieces {
    using NodeType = typename Scheme::template NodeOf<2>;
    using BodyType = Body<2, Point<2>, NodeType, NeoHookean, Tensor<2, Hat>, Flip>;
    Lattice<2> lattice;
    std::vector<BodyType> bodies;

    Pieces() : lattice(Vec<2>::Zero(), Vec<2>::Constant(h), {20, 20}) {}

    /// A rectangle of 2 x 2 particles in a cell, with velocity v.
    void add(const Vec<2>& low, const Vec<2>& high, const Vec<2>& v, double density = 1) {
        std::vector<Point<2>> points = particles_inside<Point<2>>(Box{low, high}, lattice, middles(2), density);
        for (Point<2>& p : points) p.v = v;
        bodies.push_back(BodyType{{points, Grid<2, NodeType>(lattice), NeoHookean{100, 100, density}}, Tensor<2, Hat>{lattice, {}}, Flip{}});
    }
    /// Rows of nodes where the bodies meet must carry all kinds of velocities.
    void stir(double size) {
        int k = 0;
        for (BodyType& body : bodies)
            for (Point<2>& p : body.points) ++k, p.v += size * Vec<2>(std::sin(1.7 * k), std::cos(2.3 * k));
    }
    Vec<2> momentum() const {
        Vec<2> sum = Vec<2>::Zero();
        for (const BodyType& body : bodies)
            for (const Point<2>& p : body.points) sum += p.m * p.v;
        return sum;
    }
    double in_play() const {
        double sum = 0;
        for (const BodyType& body : bodies)
            for (const Point<2>& p : body.points) sum += p.m * p.v.norm();
        return sum;
    }
    template <class Coupling> void run(Coupling& coupling, int steps, double dt) {
        for (int k = 0; k < steps; ++k) Scheme{}.step(bodies, coupling, FreeScene{}, k * dt, dt);
    }
};

inline ContactChoice choice(const char* normals, const char* common, const char* gap, double mu = 0.3) {
    ContactChoice c;
    c.normals = normals, c.common = common, c.gap = gap, c.mu = mu;
    return c;
}

}  // namespace mpm::test
