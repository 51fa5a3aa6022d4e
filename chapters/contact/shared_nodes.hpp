/// The nodes that two bodies, or a body and a wall, share, and what each of them brings there (review 5.1, figure 44). Nothing else carries
/// a field of contact: a node's place in the list, one number a node and body, finds them.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "chapters/contact/choice.hpp"
#include "chapters/contact/rigid_wall.hpp"
#include "lab/body.hpp"

namespace mpm {

/// A particle near a shared node.
template <int D> struct CloudPoint {
    Vec<D> x;         // position from the node [length]
    double r;         // half the size it had at the start [length]
    const Mat<D>* F;  // its deformation gradient

    /// How far it reaches along n, as a ball that has deformed.
    double extent(const Vec<D>& n) const { return r * (F->transpose() * n).norm(); }
};

/// What a body or a wall has on a shared node.
template <int D> struct Side {
    int party = 0;                                                // number of the body; those of walls follow
    double m = 0;                                                 // mass; infinite for a wall
    Vec<D> v_start = Vec<D>::Zero(), v = Vec<D>::Zero();          // velocity at t; at t + dt, which contact corrects
    Vec<D> out = Vec<D>::Zero();                                  // sum of gradients, points outwards [any weight/length]
    Vec<D> x = Vec<D>::Zero();                                    // mean position of its mass, from the node
    std::uint32_t first = 0, count = 0;                           // its particles near the node
    bool changed = false;                                         // by contact
};

template <int D> struct SharedNode {
    int node = 0;
    Vec<D> x = Vec<D>::Zero();           // position
    std::uint32_t first = 0, count = 0;  // its sides
};

template <int D> class SharedNodes {
public:
    std::vector<SharedNode<D>> nodes;
    std::vector<Side<D>> sides;            // node by node, by number of the party
    std::vector<CloudPoint<D>> particles;  // side by side

    /// Lists the nodes with mass of two bodies, or with that of one beside a wall. Masses must be final.
    template <class Bodies> void find(const Bodies& bodies, const std::vector<RigidWall<D>>& walls, double t) {
        for (const SharedNode<D>& shared : nodes)
            for (std::size_t b = 0; b < bodies_; ++b) side_of_[at(b, shared.node)] = -1;
        nodes.clear(), sides.clear(), particles.clear(), found_.clear();
        lattice_ = bodies[0].grid.lattice();
        bodies_ = bodies.size();
        const auto size = static_cast<std::size_t>(lattice_.size());
        if (bodies_ + walls.size() < 2) return;
        side_of_.resize(size * bodies_, -1);
        near_wall_.resize(walls.size());
        for (std::size_t w = 0; w < walls.size(); ++w) walls[w].mark(lattice_, t, near_wall_[w]);
        for (int I = 0; I < lattice_.size(); ++I) {
            std::size_t present = 0;
            for (const auto& body : bodies) present += body.grid[I].m > 0 ? 1 : 0;
            if (present == 0) continue;
            for (const std::vector<char>& near : near_wall_) present += near[static_cast<std::size_t>(I)] != 0 ? 1 : 0;
            if (present > 1) add(bodies, walls, I, t);
        }
    }

    /// Gathers from the particles what normals and gaps are made of.
    template <class Bodies>
    void measure(const Bodies& bodies, const std::vector<RigidWall<D>>& walls, const ContactChoice& choice, double t) {
        if (nodes.empty()) return;
        for (const auto& body : bodies) measure_body(body, static_cast<std::size_t>(&body - &bodies[0]), choice);
        measure_walls(walls, t);
        sort_particles();
        for (Side<D>& side : sides)
            if (!is_wall(side)) side.x /= side.m;
    }
    const Lattice<D>& lattice() const { return lattice_; }
    std::span<Side<D>> of(const SharedNode<D>& node) { return {sides.data() + node.first, node.count}; }
    bool is_wall(const Side<D>& side) const { return side.party >= static_cast<int>(bodies_); }
    std::size_t wall(const Side<D>& side) const { return static_cast<std::size_t>(side.party) - bodies_; }

private:
    std::size_t at(std::size_t body, int I) const { return static_cast<std::size_t>(I) * bodies_ + body; }

    template <class Bodies> void add(const Bodies& bodies, const std::vector<RigidWall<D>>& walls, int I, double t) {
        SharedNode<D> shared{I, lattice_.position(I), static_cast<std::uint32_t>(sides.size()), 0};
        for (std::size_t b = 0; b < bodies_; ++b) {
            const auto& node = bodies[b].grid[I];
            if (!(node.m > 0)) continue;
            side_of_[at(b, I)] = static_cast<int>(sides.size());
            Side<D>& side = sides.emplace_back();
            side.party = static_cast<int>(b);
            side.m = node.m;
        }
        for (std::size_t w = 0; w < walls.size(); ++w) {
            if (near_wall_[w][static_cast<std::size_t>(I)] == 0) continue;
            Side<D>& side = sides.emplace_back();
            side.party = static_cast<int>(bodies_ + w);
            side.m = std::numeric_limits<double>::infinity();
            side.v_start = side.v = walls[w].velocity(t);
        }
        shared.count = static_cast<std::uint32_t>(sides.size()) - shared.first;
        nodes.push_back(shared);
    }

    /// Marks the cells within `reach` of shared nodes, so that other particles cost nothing but a look.
    void mark_cells(int reach) {
        near_.assign(static_cast<std::size_t>(cell_count()), 0);
        for (const SharedNode<D>& shared : nodes) {
            std::array<int, 2> low{}, high{};
            for (int d = 0; d < D; ++d) {
                const auto axis = static_cast<std::size_t>(d);
                low[axis] = std::max(lattice_.along(shared.node, d) - reach, 0);
                high[axis] = std::min(lattice_.along(shared.node, d) + reach, lattice_.cells(d)) - 1;
            }
            for (int j = low[1]; j <= high[1]; ++j)
                for (int i = low[0]; i <= high[0]; ++i) near_[static_cast<std::size_t>(j * lattice_.cells(0) + i)] = 1;
        }
    }
    int cell_count() const {
        int n = 1;
        for (int d = 0; d < D; ++d) n *= lattice_.cells(d);
        return n;
    }
    bool near(const Vec<D>& x) const {
        int cell = 0;
        for (int d = D; d-- > 0;)
            cell = cell * lattice_.cells(d) + std::min(static_cast<int>(lattice_.in_cells(x[d], d)), lattice_.cells(d) - 1);
        return near_[static_cast<std::size_t>(cell)] != 0;
    }

    template <class Body> void measure_body(const Body& body, std::size_t b, const ContactChoice& choice) {
        const bool density = choice.kind() == ContactChoice::Normals::density;
        constexpr int reach = (Body::Shape::rows + 1) / 2;
        mark_cells(density ? std::max(reach, 2) : reach);
        const bool by_mass = choice.kind() == ContactChoice::Normals::gradient;
        for (std::size_t i = 0; i < body.points.size(); ++i) {
            const auto& p = body.points[i];
            if (!near(p.x)) continue;
            for (const auto& [node, phi, grad] : body.shape(p, i)) {
                const int k = side_of_[at(b, node)];
                if (k < 0 || !(phi > 0)) continue;
                Side<D>& side = sides[static_cast<std::size_t>(k)];
                const Vec<D> from_node = p.x - lattice_.position(node);
                if (!density) side.out += (by_mass ? p.m : p.V) * grad;
                side.x += phi * p.m * from_node;
                found_.emplace_back(k, CloudPoint<D>{from_node, 0.5 * std::pow(p.V0, 1.0 / D), &p.F});
                ++side.count;
            }
            if (density) each_density_weight(p.x, p.m, [&](int node, const Vec<D>& weight) {
                if (const int k = side_of_[at(b, node)]; k >= 0) sides[static_cast<std::size_t>(k)].out += weight;
            });
        }
    }
    /// Rigid particles have the size of their spacing, and no gradient but that of their volume.
    void measure_walls(const std::vector<RigidWall<D>>& walls, double t) {
        static const Mat<D> rigid = identity<D>();
        for (const SharedNode<D>& shared : nodes)
            for (std::uint32_t s = shared.first; s < shared.first + shared.count; ++s) {
                Side<D>& side = sides[s];
                if (side.party < static_cast<int>(bodies_)) continue;
                const RigidWall<D>& wall = walls[static_cast<std::size_t>(side.party) - bodies_];
                wall.around(lattice_, shared.x, t, [&](const Vec<D>& x, const Vec<D>& grad) {
                    side.out += std::pow(wall.spacing, D) * grad;
                    side.x += x - shared.x;
                    found_.emplace_back(static_cast<int>(s), CloudPoint<D>{x - shared.x, 0.5 * wall.spacing, &rigid});
                    ++side.count;
                });
                if (side.count > 0) side.x /= side.count;
            }
    }

    /// The contributions of a particle at x to sum over cells of grad phi(x_c) rho_c (5.9 to 5.11): S^2 is the quadratic B-spline about a
    /// cell's middle (its limits are h/2 and 3h/2), phi the hat function, whose gradient at a middle is +-1/(2h).
    template <class Add> void each_density_weight(const Vec<D>& x, double m, Add&& add) const {
        const auto spline = [](double r) {
            r = std::abs(r);
            return r < 0.5 ? 0.75 - r * r : r < 1.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0.0;
        };
        std::array<int, 2> first{}, last{};
        for (int d = 0; d < D; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            const int cell = static_cast<int>(lattice_.in_cells(x[d], d));
            first[axis] = std::max(cell - 1, 0), last[axis] = std::min(cell + 2, lattice_.nodes(d) - 1);
        }
        for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i) {
                const std::array<int, 2> at_axis{i, j};
                Vec<D> slope, mean;
                for (int d = 0; d < D; ++d) {
                    const double r = lattice_.in_cells(x[d], d) - at_axis[static_cast<std::size_t>(d)];
                    const double below = spline(r + 0.5), above = spline(r - 0.5);
                    slope[d] = (below - above) * lattice_.per_h()[d], mean[d] = 0.5 * (below + above);
                }
                Vec<D> weight = m * slope * lattice_.per_h().prod();
                for (int d = 0; d < D; ++d)
                    if (D == 2) weight[d] *= mean[D - 1 - d];
                add(j * lattice_.nodes(0) + i, weight);
            }
    }

    void sort_particles() {
        std::uint32_t total = 0;
        for (Side<D>& side : sides) side.first = total, total += side.count, side.count = 0;
        particles.resize(total);
        for (const auto& [k, p] : found_) {
            Side<D>& side = sides[static_cast<std::size_t>(k)];
            particles[side.first + side.count++] = p;
        }
    }

    Lattice<D> lattice_;
    std::size_t bodies_ = 0;
    std::vector<int> side_of_;  // by node and body; -1 where it is not shared
    std::vector<char> near_;    // cells
    std::vector<std::vector<char>> near_wall_;  // nodes, of each wall
    std::vector<std::pair<int, CloudPoint<D>>> found_;
};

}  // namespace mpm
