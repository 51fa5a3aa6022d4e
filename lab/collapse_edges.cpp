// Tiny edges, made points of.
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "lab/tidy_cells.hpp"
#include "lab/voronoi_contacts.hpp"

namespace mpm {
namespace {

using Loop = std::vector<int>;

class Collapser {
public:
    explicit Collapser(ClippedCells& cells) : cells_(cells), around_(cells.points.size()), now_(cells.points.size()) {
        for (std::size_t p = 0; p < now_.size(); ++p) now_[p] = static_cast<int>(p);
        for (std::size_t i = 0; i < cells.corners.size(); ++i)
            for (const int p : cells.corners[i]) around(p).push_back(i);
    }
    void all(double shortest) {
        std::vector<std::tuple<double, int, int>> edges;
        for (const Loop& loop : cells_.corners)
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int a = loop[k], b = loop[(k + 1) % loop.size()];
                if (const double length = (at(a) - at(b)).norm(); length < shortest)
                    edges.emplace_back(length, std::min(a, b), std::max(a, b));
            }
        std::sort(edges.begin(), edges.end());
        for (const auto& [length, a, b] : edges) {
            const int p = stands_for(a), q = stands_for(b);
            if (p != q && (at(p) - at(q)).norm() < shortest) collapse(p, q);
        }
    }

private:
    struct Merge {
        int kept, gone;
        Vec<2> x;
    };
    Vec<2>& at(int p) { return cells_.points[static_cast<std::size_t>(p)]; }
    int kind(int p) const { return cells_.kinds[static_cast<std::size_t>(p)]; }
    std::vector<std::size_t>& around(int p) { return around_[static_cast<std::size_t>(p)]; }
    int stands_for(int p) const {
        while (now_[static_cast<std::size_t>(p)] != p) p = now_[static_cast<std::size_t>(p)];
        return p;
    }

    /// Which of the two ends moves, and where to; none if the outline would change. `inner` edges have cells on both sides.
    std::optional<Merge> merged(int p, int q, bool inner) {
        if (kind(p) == free_point && kind(q) == free_point) return Merge{p, q, (at(p) + at(q)) / 2};
        if (kind(q) == free_point || (kind(p) == fixed_point && kind(q) != fixed_point)) std::swap(p, q);  // q stays
        if (kind(p) == free_point) return inner ? std::optional(Merge{q, p, at(q)}) : std::nullopt;
        const bool along_one_wall = !inner && kind(p) >= 0 && (kind(q) == fixed_point || kind(q) == kind(p));
        return along_one_wall ? std::optional(Merge{q, p, at(q)}) : std::nullopt;
    }

    /// Cells that have both ends; none if one would lose its area, or has them apart from each other.
    std::optional<std::size_t> cells_between(int p, int q) {
        std::size_t count = 0;
        for (const std::size_t i : around(p)) {
            const Loop& loop = cells_.corners[i];
            const auto found = std::find(loop.begin(), loop.end(), q);
            if (found == loop.end()) continue;
            const auto n = loop.size(), k = static_cast<std::size_t>(found - loop.begin());
            if (n < 4 || (loop[(k + 1) % n] != p && loop[(k + n - 1) % n] != p)) return std::nullopt;
            ++count;
        }
        return count;
    }

    void collapse(int p, int q) {
        const auto between = cells_between(p, q);
        if (!between) return;
        const auto merge = merged(p, q, *between == 2);
        if (!merge) return;
        std::vector<std::size_t> changed = around(p);
        changed.insert(changed.end(), around(q).begin(), around(q).end());
        std::sort(changed.begin(), changed.end());
        changed.erase(std::unique(changed.begin(), changed.end()), changed.end());

        const Vec<2> before = at(merge->kept);
        at(merge->kept) = merge->x;
        std::vector<Loop> loops;
        for (const std::size_t i : changed) {
            Loop loop = cells_.corners[i];
            const bool both = std::find(loop.begin(), loop.end(), merge->kept) != loop.end();
            const auto gone = std::find(loop.begin(), loop.end(), merge->gone);
            if (gone != loop.end() && both) loop.erase(gone);
            if (gone != loop.end() && !both) *gone = merge->kept;
            if (!is_simple(cells_.points, loop)) {
                at(merge->kept) = before;
                return;
            }
            loops.push_back(std::move(loop));
        }
        for (std::size_t k = 0; k < changed.size(); ++k) cells_.corners[changed[k]] = std::move(loops[k]);
        around(merge->gone).clear();
        around(merge->kept) = std::move(changed);
        now_[static_cast<std::size_t>(merge->gone)] = merge->kept;
    }

    ClippedCells& cells_;
    std::vector<std::vector<std::size_t>> around_;  // cells at each point
    std::vector<int> now_;                          // the point that a point has become part of
};

}  // namespace

void collapse_short_edges(double shortest, ClippedCells& cells) { Collapser(cells).all(shortest); }

PolygonCells compact(const ClippedCells& cells) {
    PolygonCells mesh;
    std::vector<int> number(cells.points.size(), -1);
    for (const Loop& loop : cells.corners) {
        auto& corners = mesh.corners.emplace_back();
        for (const int p : loop) {
            int& n = number[static_cast<std::size_t>(p)];
            if (n < 0) {
                n = static_cast<int>(mesh.points.size());
                mesh.points.push_back(cells.points[static_cast<std::size_t>(p)]);
            }
            corners.push_back(n);
        }
    }
    return mesh;
}

}  // namespace mpm
