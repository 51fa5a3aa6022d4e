/// What particles carry from step to step. Their residual is tested with grid functions only, so that it does not control the part of a
/// particle's acceleration that the grid cannot see; once particles have changed cells, that part is felt. Here are the published way and
/// those that were tried against it (notes.md).
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "chapters/implicit/active.hpp"
#include "chapters/implicit/newmark.hpp"
#include "lab/sparse_system.hpp"

namespace mpm {

enum class Carry {
    particle,   // Newmark's acceleration at the particles, as published
    lumped,     // the same mapped to the grid with lumped masses and back
    projected,  // the same projected onto the grid's functions (consistent masses)
    midpoint,   // no acceleration: midpoint rule, v_new = 2 u/dt - v
    increment,  // the same with what the grid sees of the old velocity: v_new = v + 2 (u/dt - P v)
    conserving  // midpoint with the stress whose work is the change of the stored energy
};
inline const std::vector<std::string>& carry_names() {
    static const std::vector<std::string> names{"particle", "lumped", "projected", "midpoint", "increment", "conserving"};
    return names;
}
inline Carry carry_of(const std::string& name) {
    for (std::size_t i = 0; i < carry_names().size(); ++i)
        if (carry_names()[i] == name) return static_cast<Carry>(i);
    return Carry::particle;
}
inline bool by_midpoint(Carry carry) { return carry >= Carry::midpoint; }

/// Maps a field of the particles to the active grid and back, with lumped masses or by projection, min sum m (sum phi_I f_I - f)^2.
template <class Element, int D> class Projection {
public:
    Projection(const Rectilinear<D>& grid, const ActiveGrid<D>& active) : grid_(grid), active_(active) {
        number_.assign(static_cast<std::size_t>(grid.size()), -1);
        for (std::size_t I = 0; I < number_.size(); ++I)
            if (active.node_is_active[I]) number_[I] = nodes_++;
    }

    /// False if masses are singular.
    template <class Points> bool apply(const Points& points, bool lumped, std::vector<Vec<D>>& field) {
        const auto count = static_cast<std::size_t>(nodes_);
        std::vector<double> m(count, 0);
        std::vector<std::vector<double>> mf(D, std::vector<double>(count, 0)), nodal = mf;
        std::vector<std::vector<int>> unknowns;
        for (const int e : active_.elements) unknowns.push_back(numbers(e));
        SparseSystem mass;
        if (!lumped) mass.use(nodes_, unknowns), mass.clear();
        for (std::size_t a = 0; a < active_.elements.size(); ++a) {
            std::array<double, N * N> M{};
            each(a, points, [&](std::size_t p, const auto& w) {
                for (std::size_t i = 0; i < N; ++i) {
                    const auto I = static_cast<std::size_t>(unknowns[a][i]);
                    m[I] += points[p].m * w.phi[i];
                    for (std::size_t d = 0; d < D; ++d) mf[d][I] += points[p].m * w.phi[i] * field[p][static_cast<Eigen::Index>(d)];
                    for (std::size_t k = 0; k < N; ++k) M[i * N + k] += points[p].m * w.phi[i] * w.phi[k];
                }
            });
            if (!lumped) mass.add(static_cast<int>(a), M.data());
        }
        for (std::size_t d = 0; d < D; ++d) {
            if (!lumped && !mass.solve(mf[d], nodal[d])) return false;
            for (std::size_t I = 0; I < count && lumped; ++I) nodal[d][I] = m[I] > 0 ? mf[d][I] / m[I] : 0;
        }
        for (std::size_t a = 0; a < active_.elements.size(); ++a)
            each(a, points, [&](std::size_t p, const auto& w) {
                field[p] = Vec<D>::Zero();
                for (std::size_t i = 0; i < N; ++i)
                    for (std::size_t d = 0; d < D; ++d)
                        field[p][static_cast<Eigen::Index>(d)] += w.phi[i] * nodal[d][static_cast<std::size_t>(unknowns[a][i])];
            });
        return true;
    }

private:
    static constexpr std::size_t N = static_cast<std::size_t>(power(Element::count, D));
    std::vector<int> numbers(int element) const {
        std::vector<int> all;
        for (std::size_t k = 0; k < N; ++k) all.push_back(number_[static_cast<std::size_t>(grid_.node(element, static_cast<int>(k)))]);
        return all;
    }
    template <class Points, class Visit> void each(std::size_t a, const Points& points, Visit&& visit) const {
        for (std::size_t i = active_.begin[a]; i < active_.begin[a + 1]; ++i) {
            const std::size_t p = active_.particles[i];
            visit(p, element_weights<Element, D>(grid_, active_.elements[a], points[p].x));
        }
    }

    const Rectilinear<D>& grid_;
    const ActiveGrid<D>& active_;
    std::vector<int> number_;
    int nodes_ = 0;
};

}  // namespace mpm
