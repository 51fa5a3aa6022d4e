// Cells of many corners, cut along diagonals.
#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/orientation.hpp"
#include "lab/tidy_cells.hpp"

namespace mpm {
namespace {

using Loop = std::vector<int>;

/// Whether two segments have a point in common.
bool meet(const Vec<2>& a, const Vec<2>& b, const Vec<2>& p, const Vec<2>& q) {
    if (((a.cwiseMax(b) - p.cwiseMin(q)).array() < 0).any() || ((p.cwiseMax(q) - a.cwiseMin(b)).array() < 0).any()) return false;
    return orientation(a, b, p) * orientation(a, b, q) <= 0 && orientation(p, q, a) * orientation(p, q, b) <= 0;
}

class Cutter {
public:
    Cutter(const std::vector<Vec<2>>& points, const Loop& loop) : points_(points), loop_(loop) {}

    /// The corners that the best diagonal joins; equal if none was found.
    std::pair<std::size_t, std::size_t> best() const {
        constexpr std::size_t few = 64, enough = 16;  // corners of which all diagonals are tried; diagonals found of more corners
        const std::size_t n = loop_.size();
        std::pair<std::size_t, std::size_t> cut{0, 0};
        double roundest = 0;
        std::size_t found = 0;
        for (std::size_t apart = n / 2; apart >= 2; --apart)  // the most even cuts first
            for (std::size_t i = 0; i < n && (n <= few || found < enough); ++i) {
                if (!inside(i, (i + apart) % n)) continue;
                ++found;
                const double round = std::min(roundness(i, apart), roundness((i + apart) % n, n - apart));
                if (round > roundest) roundest = round, cut = {i, (i + apart) % n};
            }
        return cut;
    }

private:
    const Vec<2>& at(std::size_t k) const { return points_[static_cast<std::size_t>(loop_[k % loop_.size()])]; }
    int turn(std::size_t a, std::size_t b, std::size_t c) const { return orientation(at(a), at(b), at(c)); }
    /// Whether the direction from corner i to j lies between the edges at i.
    bool between_edges(std::size_t i, std::size_t j) const {
        const std::size_t before = i + loop_.size() - 1, after = i + 1;
        if (turn(before, i, after) > 0) return turn(i, j, before) > 0 && turn(j, i, after) > 0;
        return !(turn(i, j, after) >= 0 && turn(j, i, before) >= 0);
    }
    bool inside(std::size_t i, std::size_t j) const {
        if (!between_edges(i, j) || !between_edges(j, i)) return false;
        const std::size_t n = loop_.size();
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t next = (k + 1) % n;
            if (k == i || k == j || next == i || next == j) continue;
            if (meet(at(i), at(j), at(k), at(next))) return false;
        }
        return true;
    }
    /// Area over squared perimeter of the part from corner i to the one `count` edges on.
    double roundness(std::size_t i, std::size_t count) const {
        double twice = 0, around = (at(i + count) - at(i)).norm();
        for (std::size_t k = i; k < i + count; ++k) {
            const Vec<2> a = at(k) - at(i), b = at(k + 1) - at(i);
            twice += a[0] * b[1] - a[1] * b[0];
            around += (b - a).norm();
        }
        return twice / (around * around);
    }

    const std::vector<Vec<2>>& points_;
    const Loop& loop_;
};

}  // namespace

bool is_simple(const std::vector<Vec<2>>& points, const std::vector<int>& corners) {
    const std::size_t n = corners.size();
    const auto at = [&](std::size_t k) -> const Vec<2>& { return points[static_cast<std::size_t>(corners[k % n])]; };
    double twice = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const Vec<2> a = at(k) - at(0), b = at(k + 1) - at(0);
        twice += a[0] * b[1] - a[1] * b[0];
        const Vec<2> in = at(k + 1) - at(k), out = at(k + 2) - at(k + 1);
        if (orientation(at(k), at(k + 1), at(k + 2)) == 0 && in.dot(out) <= 0) return false;  // back the way it came
        for (std::size_t l = k + 2; l < n; ++l)
            if ((l + 1) % n != k && meet(at(k), at(k + 1), at(l), at(l + 1))) return false;
    }
    return n >= 3 && twice > 0;
}

void cut_cells(std::size_t most, ClippedCells& cells) {
    for (std::size_t i = 0; i < cells.corners.size(); ++i)
        while (cells.corners[i].size() > most) {
            const Loop loop = cells.corners[i];
            const auto [a, b] = Cutter(cells.points, loop).best();
            if (a == b) break;
            Loop one, other;
            for (std::size_t k = a; k != b; k = (k + 1) % loop.size()) one.push_back(loop[k]);
            for (std::size_t k = b; k != a; k = (k + 1) % loop.size()) other.push_back(loop[k]);
            one.push_back(loop[b]);
            other.push_back(loop[a]);
            cells.corners[i] = std::move(one);
            cells.corners.push_back(std::move(other));
            cells.seed.push_back(cells.seed[i]);
        }
}

}  // namespace mpm
