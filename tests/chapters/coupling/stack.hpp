/// A block of particles that comes down on a layer of finite elements, for tests of whole steps.
#pragma once
#include <vector>

#include "chapters/coupling/monolithic.hpp"

namespace mpm {

struct StackNode {
    void reset() {}
};

struct StackScene {
    NeoHookean plate{60, 40, 2};
    bool held_floor = false;

    std::vector<char> held(const Rectilinear<2>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()) * 2, 0);
        if (held_floor) std::fill_n(all.begin(), 2 * grid.nodes(0), 1);
        return all;
    }
    std::vector<char> reset_held(const Rectilinear<2>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()) * 2, 0);
        std::fill_n(all.end() - 2 * grid.nodes(0), 2 * grid.nodes(0), 1);
        return all;
    }
    std::vector<int> fem_elements(const Rectilinear<2>&) const { return {0, 1, 2, 3}; }
    NeoHookean fem_law() const { return plate; }
    Vec<2> body_force(double) const { return Vec<2>::Zero(); }
    Vec<2> fem_body_force(double) const { return Vec<2>::Zero(); }
    /// It bends and spins.
    template <class NodeState> void fem_start(const Vec<2>& X, NodeState& node) const {
        node.u = 0.03 * Vec<2>(X[1] * (X[0] - 2), (X[0] - 1) * (X[0] - 3));
        node.v = Vec<2>(0.1 - 0.2 * X[1], 0.2 * (X[0] - 2));
    }
};

using StackBody = Matter<2, ImplicitPoint<2>, StackNode, NeoHookean>;
using StackMethod = ImplicitMpm<QuadraticElement, StackBody, StackScene, FemBody<QuadraticElement, StackBody>>;

/// 4 x 4 elements; the lowest layer, 0.8 high, is the finite element body. The block fills 1 < x < 3, 0.85 < y < 2.85 with 4 x 4 particles
/// and more to an element, and begins in the layer of elements over the body.
struct Stack {
    StackScene scene;
    StackBody body;
    Rectilinear<2> grid{{even_lines(0, 4, 4), Lines{0, 0.8, 1.8, 2.8, 4}}, sharing_of<QuadraticElement>()};

    Stack() {
        body.law = {30, 20, 1};
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 8; ++i) {
                auto& p = body.points.emplace_back();
                p.x = p.X = Vec<2>(1 + 0.25 * (i + 0.5), 0.85 + 0.25 * (j + 0.5));
                p.V = p.V0 = 0.0625;
                p.m = body.law.rho * p.V0;
                p.v = Vec<2>(0.3 - 0.1 * (p.x[1] - 1), -0.8 + 0.1 * (p.x[0] - 2));
            }
    }
    static ImplicitSettings settings(Carry carry) {
        ImplicitSettings s;
        s.carry = carry;
        if (by_midpoint(carry)) s.newmark = Newmark::midpoint();
        s.automatic = carry == Carry::conserving;
        s.newton.tolerance = 1e-13;
        return s;
    }
    StackMethod method(const ImplicitSettings& s) { return {s, grid, body, scene}; }
    Measures measure(const StackMethod& m) const {
        Measures sum;
        add_measures(body, sum);
        m.attached().measure(sum);
        return sum;
    }
};

}  // namespace mpm
