/// The reset displacement of a background grid that is attached to a finite element body (Aulisa and Capodaglio, 2.3, equation 8): on the
/// body the nodes stay where they are, around it they go back to the elastic extension of its displacement, which decays away from it.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "chapters/implicit/active.hpp"
#include "lab/sparse_system.hpp"

namespace mpm {

/// Solves div(grad u + grad u^T) = 0 on the undeformed background with u given at the body's nodes, zero where `held` says so, and no
/// traction on the rest of the border (unsaid in the source). The matrix is constant: it is factorised once.
template <class Element, int D> class ElasticExtension {
public:
    static constexpr int N = power(Element::count, D);

    /// `background` are its elements; `given` are the nodes of the body; `held`, for each component of each node.
    void use(const Rectilinear<D>& grid, const std::vector<int>& background, const std::vector<char>& given,
             const std::vector<char>& held) {
        number_.assign(held.size(), -1);
        std::vector<char> in_background(given.size(), 0);
        for (const int e : background)
            for (int k = 0; k < N; ++k) in_background[static_cast<std::size_t>(grid.node(e, k))] = 1;
        unknowns_ = 0;
        for (std::size_t i = 0; i < number_.size(); ++i)
            if (in_background[i / D] && !given[i / D] && !held[i]) number_[i] = unknowns_++;
        std::vector<std::vector<int>> elements;
        for (const int e : background) {
            auto& numbers = elements.emplace_back();
            for (int i = 0; i < N * D; ++i) numbers.push_back(number_[component(grid, e, i)]);
        }
        system_.use(unknowns_, elements);
        system_.clear();
        for (std::size_t a = 0; a < background.size(); ++a) {
            const Matrix K = soft_matrix<Element>(grid, background[a]);
            system_.add(static_cast<int>(a), K.data());
            bool touches = false;
            for (int k = 0; k < N; ++k) touches = touches || given[static_cast<std::size_t>(grid.node(background[a], k))];
            if (touches) at_body_.push_back({background[a], K});
        }
    }
    /// Writes the displacement of the background's nodes, all but the body's. False if the system is singular: nothing is held.
    bool extend(const Rectilinear<D>& grid, std::vector<Vec<D>>& u) {
        std::vector<double> b(static_cast<std::size_t>(unknowns_), 0), x;
        bool moved = false;
        for (const auto& [e, K] : at_body_) {
            Eigen::Matrix<double, N * D, 1> known;
            for (int i = 0; i < N * D; ++i) known[i] = number_[component(grid, e, i)] < 0 ? u[component(grid, e, i) / D][i % D] : 0;
            moved = moved || !known.isZero(0);
            const Eigen::Matrix<double, N * D, 1> r = K * known;
            for (int i = 0; i < N * D; ++i)
                if (const int n = number_[component(grid, e, i)]; n >= 0) b[static_cast<std::size_t>(n)] -= r[i];
        }
        if (!moved) x.assign(b.size(), 0);
        else if (!system_.solve(b, x)) return false;
        for (std::size_t i = 0; i < number_.size(); ++i)
            if (number_[i] >= 0) u[i / D][static_cast<Eigen::Index>(i % D)] = x[static_cast<std::size_t>(number_[i])];
        return true;
    }

private:
    using Matrix = Eigen::Matrix<double, N * D, N * D, Eigen::RowMajor>;
    static std::size_t component(const Rectilinear<D>& grid, int e, int i) {
        return static_cast<std::size_t>(grid.node(e, i / D) * D + i % D);
    }
    struct AtBody {
        int element;
        Matrix K;
    };
    SparseSystem system_;
    int unknowns_ = 0;
    std::vector<int> number_;      // unknown of each component of each node, -1 for none
    std::vector<AtBody> at_body_;  // elements that share nodes with the body
};

}  // namespace mpm
