/// A block of neo-Hookean particles on a small grid of Q9 elements, for tests of whole steps.
#pragma once
#include <vector>

#include "chapters/implicit/implicit.hpp"

namespace mpm {

struct BlockNode {
    void reset() {}
};

struct BlockScene {
    Vec<2> b = Vec<2>::Zero();  // body force per mass
    bool held_floor = false;

    std::vector<char> held(const Rectilinear<2>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()) * 2, 0);
        if (held_floor) std::fill_n(all.begin(), 2 * grid.nodes(0), 1);
        return all;
    }
    Vec<2> body_force(double) const { return b; }
};

using BlockBody = Matter<2, ImplicitPoint<2>, BlockNode, NeoHookean>;
using BlockMethod = ImplicitMpm<QuadraticElement, BlockBody, BlockScene>;

/// 4 x 4 elements of size 1 and less; the block fills 1 < x < 3, 0 < y < 2 with 4 x 4 particles to an element, spinning and swelling.
struct Block {
    BlockScene scene;
    BlockBody body;
    Rectilinear<2> grid{{even_lines(0, 4, 4), Lines{0, 0.8, 1.7, 2.8, 4}}, sharing_of<QuadraticElement>()};

    explicit Block(const NeoHookean& law = {30, 20, 1}) {
        body.law = law;
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 8; ++i) {
                auto& p = body.points.emplace_back();
                p.x = p.X = Vec<2>(1 + 0.25 * (i + 0.5), 0.25 * (j + 0.5));
                p.V = p.V0 = 0.0625;
                p.m = law.rho * p.V0;
                p.v = Vec<2>(0.3 - 0.5 * (p.x[1] - 1), 0.2 + 0.4 * (p.x[0] - 2));
            }
    }
    double energy() const {
        double sum = 0;
        for (const auto& p : body.points) sum += 0.5 * p.m * p.v.squaredNorm() + body.law.energy(p);
        return sum;
    }
    Vec<2> momentum() const {
        Vec<2> sum = Vec<2>::Zero();
        for (const auto& p : body.points) sum += p.m * p.v;
        return sum;
    }
};

}  // namespace mpm
