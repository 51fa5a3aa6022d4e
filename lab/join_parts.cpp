// Slivers that clipping leaves, joined to their neighbours.
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>

#include "lab/tidy_cells.hpp"

namespace mpm {
namespace {

using Loop = std::vector<int>;

class Joiner {
public:
    Joiner(std::size_t most, ClippedCells& cells) : most_(most), cells_(cells) {
        for (std::size_t i = 0; i < cells.corners.size(); ++i) own_edges(i);
    }
    /// Gives part i to a neighbour, if one can take it; it is then left without corners.
    void give_away(std::size_t i) {
        std::map<std::size_t, double> shared;
        const Loop& loop = cells_.corners[i];
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (const auto other = beyond(loop, k)) shared[*other] += length(loop, k);
        std::vector<std::pair<double, std::size_t>> order;
        for (const auto& [other, sum] : shared) order.emplace_back(-sum, other);
        std::sort(order.begin(), order.end());
        for (const auto& [sum, other] : order) {
            Loop both = joined(loop, other);
            if (both.size() < 3 || both.size() > most_ || !is_simple(cells_.points, both)) continue;
            cells_.corners[i].clear();
            cells_.corners[other] = std::move(both);
            own_edges(other);
            return;
        }
    }

private:
    static std::uint64_t key(int from, int to) { return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to); }
    void own_edges(std::size_t i) {
        const Loop& loop = cells_.corners[i];
        for (std::size_t k = 0; k < loop.size(); ++k) owner_[key(loop[k], loop[(k + 1) % loop.size()])] = i;
    }
    double length(const Loop& loop, std::size_t k) const {
        const auto at = [&](std::size_t c) { return cells_.points[static_cast<std::size_t>(loop[c % loop.size()])]; };
        return (at(k + 1) - at(k)).norm();
    }
    std::optional<std::size_t> beyond(const Loop& loop, std::size_t k) const {
        const auto found = owner_.find(key(loop[(k + 1) % loop.size()], loop[k % loop.size()]));
        return found == owner_.end() ? std::nullopt : std::optional(found->second);
    }
    /// Both loops without what they share; empty unless that is one piece.
    Loop joined(const Loop& loop, std::size_t other) const {
        const std::size_t n = loop.size();
        const auto shared = [&](std::size_t k) { return beyond(loop, k) == other; };
        std::size_t start = n, run = 0, total = 0;
        for (std::size_t k = 0; k < n; ++k) {
            total += shared(k) ? 1 : 0;
            if (shared(k) && !shared(k + n - 1)) start = k;
        }
        if (start == n) return {};
        while (shared(start + run)) ++run;
        if (run != total) return {};
        Loop both;
        for (std::size_t k = start + run; k <= start + n; ++k) both.push_back(loop[k % n]);
        const Loop& rest = cells_.corners[other];
        const auto at = static_cast<std::size_t>(std::find(rest.begin(), rest.end(), both.back()) - rest.begin());
        for (std::size_t k = 1; k + run < rest.size(); ++k) both.push_back(rest[(at + k) % rest.size()]);
        return both;
    }

    std::size_t most_;
    ClippedCells& cells_;
    std::unordered_map<std::uint64_t, std::size_t> owner_;  // of each half of an edge; those that are no more are asked for by none
};

}  // namespace

void join_small_parts(double least, std::size_t most, ClippedCells& cells) {
    std::vector<double> area;
    std::unordered_map<int, std::size_t> largest;
    for (std::size_t i = 0; i < cells.corners.size(); ++i) {
        area.push_back(cell_moments(cells.points, cells.corners[i], i).area);
        const auto at = largest.try_emplace(cells.seed[i], i).first;
        if (area[i] > area[at->second]) at->second = i;
    }
    std::vector<std::size_t> small;
    for (std::size_t i = 0; i < area.size(); ++i)
        if (area[i] < least && largest[cells.seed[i]] != i) small.push_back(i);
    if (small.empty()) return;
    Joiner joiner(most, cells);
    for (const std::size_t i : small) joiner.give_away(i);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cells.corners.size(); ++i) {
        if (cells.corners[i].empty()) continue;
        cells.seed[kept] = cells.seed[i];
        if (kept != i) cells.corners[kept] = std::move(cells.corners[i]);
        ++kept;
    }
    cells.corners.resize(kept);
    cells.seed.resize(kept);
}

}  // namespace mpm
