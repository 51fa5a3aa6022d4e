#include "lab/voronoi_clip.hpp"

#include <algorithm>
#include <utility>

#include "lab/plane_graph.hpp"
#include "lab/triangles.hpp"
#include "lab/voronoi_contacts.hpp"

namespace mpm {
namespace {

constexpr int nobody = -1;  // no seed is known on that side

/// The touched cells and the outlines as one graph. Around each of its faces one knows whether it is inside from the walls it has, or else
/// from its neighbours; untouched cells are inside if a neighbour is.
class Clip {
public:
    Clip(const VoronoiDiagram& diagram, const Polygon& domain, double reach) : diagram_(diagram), contacts_(diagram, domain, reach) {
        add_edges();
        faces_ = trace_faces(contacts_.points, edges_);
        inside_.assign(faces_.loops.size(), 0);
        inner_cell_.assign(diagram.seeds.size(), 0);
        spread();
    }
    ClippedCells cells();

private:
    struct Label {
        int left, right;
        bool wall;
    };
    void add_edges();
    void add(const std::vector<int>& chain, const Label& label);
    int seed_at(int half) const {
        const Label& label = labels_[static_cast<std::size_t>(half / 2)];
        return half % 2 == 0 ? label.left : label.right;
    }
    bool wall(int half) const { return labels_[static_cast<std::size_t>(half / 2)].wall; }
    void spread();
    void enter_loop(int half);
    void enter_cell(int cell);
    void leave_loop(const std::vector<int>& loop);
    void leave_cell(int cell);
    std::vector<int> corners_of(const std::vector<int>& loop) const;
    std::vector<int> corners_of(int cell) const;
    int owner(const std::vector<int>& loop, const std::vector<int>& corners) const;

    const VoronoiDiagram& diagram_;
    Contacts contacts_;
    std::vector<GraphEdge> edges_;
    std::vector<Label> labels_;
    std::unordered_map<std::uint64_t, int> edge_of_;
    FaceLoops faces_;
    std::vector<char> inside_, inner_cell_;  // loops; untouched cells
    std::vector<int> loops_to_leave_, cells_to_leave_;
};

/// Where a side of a cell runs along a wall, the wall is the edge.
void Clip::add(const std::vector<int>& chain, const Label& label) {
    for (std::size_t k = 1; k < chain.size(); ++k) {
        const int a = chain[k - 1], b = chain[k];
        if (a == b || (!label.wall && contacts_.along_wall(a, b))) continue;
        if (!edge_of_.try_emplace(pair_key(a, b), static_cast<int>(edges_.size())).second) continue;
        edges_.push_back({a, b});
        labels_.push_back(label);
    }
}
void Clip::add_edges() {
    for (const MarkedLine& line : contacts_.walls) add(Contacts::chain(line), {nobody, nobody, true});
    for (const CellSide& side : contacts_.sides) add(Contacts::chain(side.line), {side.left, side.right, false});
    for (const Bridge& bridge : contacts_.bridges) add({bridge.from, bridge.to}, {bridge.seed, bridge.seed, false});
}

void Clip::spread() {
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e)
        if (wall(2 * e)) enter_loop(2 * e);
    while (!loops_to_leave_.empty() || !cells_to_leave_.empty()) {
        if (!loops_to_leave_.empty()) {
            const int loop = loops_to_leave_.back();
            loops_to_leave_.pop_back();
            leave_loop(faces_.loops[static_cast<std::size_t>(loop)]);
        } else {
            const int cell = cells_to_leave_.back();
            cells_to_leave_.pop_back();
            leave_cell(cell);
        }
    }
}
void Clip::enter_loop(int half) {
    const int loop = faces_.loop_of[static_cast<std::size_t>(half)];
    if (!std::exchange(inside_[static_cast<std::size_t>(loop)], 1)) loops_to_leave_.push_back(loop);
}
void Clip::enter_cell(int cell) {
    if (!std::exchange(inner_cell_[static_cast<std::size_t>(cell)], 1)) cells_to_leave_.push_back(cell);
}
void Clip::leave_loop(const std::vector<int>& loop) {
    for (const int half : loop) {
        if (wall(half)) continue;
        const int beyond = seed_at(half ^ 1);
        if (contacts_.touched(beyond))
            enter_loop(half ^ 1);
        else
            enter_cell(beyond);
    }
}
void Clip::leave_cell(int cell) {
    for (int k = 0; k < diagram_.count(cell); ++k) {
        const int beyond = diagram_.edge(cell, k).beyond;
        if (!contacts_.touched(beyond)) {
            enter_cell(beyond);
            continue;
        }
        const CellSide* side = contacts_.side(cell, beyond);
        if (!side) continue;
        const auto chain = Contacts::chain(side->line);
        for (std::size_t i = 1; i < chain.size(); ++i) {
            const int e = edge_of_.at(pair_key(chain[i - 1], chain[i]));  // an untouched cell has no side along a wall
            for (const int half : {2 * e, 2 * e + 1})
                if (seed_at(half) == beyond) enter_loop(half);
        }
    }
}

std::vector<int> Clip::corners_of(const std::vector<int>& loop) const {
    std::vector<int> corners;
    for (const int half : loop) {
        const GraphEdge& edge = edges_[static_cast<std::size_t>(half / 2)];
        corners.push_back(half % 2 == 0 ? edge.a : edge.b);
    }
    return corners;
}

/// Of an untouched cell: its vertices, and where bridges end on its sides.
std::vector<int> Clip::corners_of(int cell) const {
    std::vector<int> corners;
    for (int k = 0; k < diagram_.count(cell); ++k) {
        const VoronoiEdge& edge = diagram_.edge(cell, k);
        const int from = contacts_.place[static_cast<std::size_t>(edge.from)];
        if (corners.empty() || corners.back() != from) corners.push_back(from);
        const CellSide* side = contacts_.touched(edge.beyond) ? contacts_.side(cell, edge.beyond) : nullptr;
        if (!side || side->line.marks.empty()) continue;
        const auto chain = Contacts::chain(side->line);  // counter-clockwise for the other cell
        corners.insert(corners.end(), chain.rbegin() + 1, chain.rend() - 1);
    }
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners;
}

/// The seed whose cell a face belongs to.
int Clip::owner(const std::vector<int>& loop, const std::vector<int>& corners) const {
    for (const int half : loop)
        if (seed_at(half) != nobody) return seed_at(half);
    return diagram_.nearest(cell_moments(contacts_.points, corners, 0).centroid, 0);
}

ClippedCells Clip::cells() {
    ClippedCells all;
    for (std::size_t l = 0; l < faces_.loops.size(); ++l) {
        if (!inside_[l]) continue;
        auto corners = corners_of(faces_.loops[l]);
        if (corners.size() < 3) continue;
        all.seed.push_back(owner(faces_.loops[l], corners));
        all.corners.push_back(std::move(corners));
    }
    for (int i = 0; i < static_cast<int>(inner_cell_.size()); ++i) {
        if (!inner_cell_[static_cast<std::size_t>(i)]) continue;
        auto corners = corners_of(i);
        if (corners.size() < 3) continue;
        all.seed.push_back(i);
        all.corners.push_back(std::move(corners));
    }
    all.points = std::move(contacts_.points);
    all.kinds = std::move(contacts_.kinds);
    return all;
}

}  // namespace

ClippedCells clip(const VoronoiDiagram& diagram, const Polygon& domain, double reach) { return Clip(diagram, domain, reach).cells(); }

}  // namespace mpm
