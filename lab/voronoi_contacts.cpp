#include "lab/voronoi_contacts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "lab/orientation.hpp"

namespace mpm {
namespace {

double cross_product(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Where the point of a segment that is nearest to x is, 0 ... 1.
double foot(const Vec<2>& x, const Vec<2>& a, const Vec<2>& b) { return std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0); }
double distance(const Vec<2>& x, const Vec<2>& a, const Vec<2>& b) { return (x - a - foot(x, a, b) * (b - a)).norm(); }

bool cross_each_other(const Vec<2>& a, const Vec<2>& b, const Vec<2>& p, const Vec<2>& q) {
    return orientation(a, b, p) * orientation(a, b, q) < 0 && orientation(p, q, a) * orientation(p, q, b) < 0;
}

}  // namespace

Contacts::Contacts(const VoronoiDiagram& diagram, const Polygon& domain, double reach)
    : points(diagram.vertices),
      kinds(points.size(), free_point),
      place(points.size()),
      walls_of(diagram.seeds.size()),
      diagram_(diagram),
      reach_(reach),
      stamp_(diagram.seeds.size(), -1) {
    std::iota(place.begin(), place.end(), 0);
    build_walls(domain);
    touch();
    snap();
    add_sides();
    add_bridges(domain);
    const auto by_t = [](const MarkedLine::Mark& m, const MarkedLine::Mark& n) { return m.t < n.t; };
    for (MarkedLine& wall : walls) std::sort(wall.marks.begin(), wall.marks.end(), by_t);
    for (CellSide& s : sides) std::sort(s.line.marks.begin(), s.line.marks.end(), by_t);
}

int Contacts::add_point(const Vec<2>& x, int kind) {
    points.push_back(x);
    kinds.push_back(kind);
    return static_cast<int>(points.size()) - 1;
}
bool Contacts::on_wall(int point, int wall) const {
    const MarkedLine& line = walls[static_cast<std::size_t>(wall)];
    return point == line.a || point == line.b || kinds[static_cast<std::size_t>(point)] == wall;
}
bool Contacts::along_wall(int p, int q) const {
    for (const int point : {p, q}) {
        const int kind = kinds[static_cast<std::size_t>(point)];
        const int wall = kind == fixed_point ? point - static_cast<int>(diagram_.vertices.size()) : kind;  // one starts at each corner
        if (wall >= 0 && on_wall(p, wall) && on_wall(q, wall)) return true;
    }
    return false;
}
double Contacts::distance(int point, const MarkedLine& line) const { return mpm::distance(at(point), at(line.a), at(line.b)); }

/// Wall k starts at corner k of all.
void Contacts::build_walls(const Polygon& domain) {
    for (std::size_t o = 0; o < domain.outlines().size(); ++o) {
        Outline outline = domain.outlines()[o];
        if ((signed_area(outline) > 0) != (o == 0)) std::reverse(outline.begin(), outline.end());
        const int first = static_cast<int>(points.size()), n = static_cast<int>(outline.size());
        for (int k = 0; k < n; ++k) {
            add_point(outline[static_cast<std::size_t>(k)], fixed_point);
            walls.push_back({first + k, first + (k + 1) % n, {}});
        }
    }
    met_.assign(walls.size(), 0);
}

bool Contacts::close(const VoronoiEdge& from, const VoronoiEdge& to, const MarkedLine& wall) const {
    const Vec<2>&a = diagram_.vertex(from.from), &b = diagram_.vertex(to.from), &p = at(wall.a), &q = at(wall.b);
    const double reach = 2 * reach_;  // so that all cells of a vertex that moves know its wall
    if (((a.cwiseMax(b) - p.cwiseMin(q)).array() < -reach).any() || ((p.cwiseMax(q) - a.cwiseMin(b)).array() < -reach).any()) return false;
    if (mpm::distance(p, a, b) <= reach || mpm::distance(q, a, b) <= reach || mpm::distance(a, p, q) <= reach ||
        mpm::distance(b, p, q) <= reach)
        return true;
    return cross_each_other(a, b, p, q);
}

void Contacts::touch() {
    int here = 0;
    for (const MarkedLine& wall : walls) home_.push_back(here = diagram_.nearest(at(wall.a), here));
    for (int w = 0; w < static_cast<int>(walls.size()); ++w) touch(w);
}
/// From the cell of the wall's first corner to every cell along it.
void Contacts::touch(int wall) {
    std::vector<int> stack{home_[static_cast<std::size_t>(wall)]};
    stamp_[static_cast<std::size_t>(stack.back())] = wall;
    while (!stack.empty()) {
        const int cell = stack.back();
        stack.pop_back();
        walls_of[static_cast<std::size_t>(cell)].push_back(wall);
        for (int k = 0; k < diagram_.count(cell); ++k) {
            const VoronoiEdge& edge = diagram_.edge(cell, k);
            int& stamp = stamp_[static_cast<std::size_t>(edge.beyond)];
            if (stamp == wall || !close(edge, diagram_.edge(cell, k + 1), walls[static_cast<std::size_t>(wall)])) continue;
            stamp = wall;
            stack.push_back(edge.beyond);
        }
    }
}

void Contacts::snap() {
    std::vector<char> done(place.size(), 0);
    for (int i = 0; i < static_cast<int>(walls_of.size()); ++i)
        for (int k = 0; touched(i) && k < diagram_.count(i); ++k) {
            const int vertex = diagram_.edge(i, k).from;
            if (!std::exchange(done[static_cast<std::size_t>(vertex)], 1)) snap(vertex, walls_of[static_cast<std::size_t>(i)]);
        }
}
/// Moves a vertex onto a corner or, if there is none, a wall within reach.
void Contacts::snap(int vertex, const std::vector<int>& near) {
    for (const int w : near) {
        const MarkedLine& wall = walls[static_cast<std::size_t>(w)];
        for (const int corner : {wall.a, wall.b})
            if ((at(corner) - at(vertex)).norm() <= reach_) {
                place[static_cast<std::size_t>(vertex)] = corner;
                met_[static_cast<std::size_t>(corner) - diagram_.vertices.size()] = 1;
                return;
            }
    }
    for (const int w : near) {
        MarkedLine& wall = walls[static_cast<std::size_t>(w)];
        if (!(distance(vertex, wall) <= reach_)) continue;
        const double t = foot(at(vertex), at(wall.a), at(wall.b));
        points[static_cast<std::size_t>(vertex)] = at(wall.a) + t * (at(wall.b) - at(wall.a));
        kind(vertex) = w;
        wall.marks.push_back({t, vertex});
        return;
    }
}

void Contacts::add_sides() {
    for (int i = 0; i < static_cast<int>(walls_of.size()); ++i)
        for (int k = 0; touched(i) && k < diagram_.count(i); ++k) {
            const int a = place[static_cast<std::size_t>(diagram_.edge(i, k).from)],
                      b = place[static_cast<std::size_t>(diagram_.edge(i, k + 1).from)], beyond = diagram_.edge(i, k).beyond;
            if (a == b || !side_of_.try_emplace(pair_key(i, beyond), static_cast<int>(sides.size())).second) continue;
            sides.push_back({i, beyond, {a, b, {}}});
            for (const int w : walls_of[static_cast<std::size_t>(i)]) cross(sides.back().line, w);
        }
}

/// Marks where the side of a cell and a wall meet. They meet once, or the side runs along the wall with a point of either at each end.
void Contacts::cross(MarkedLine& line, int w) {
    MarkedLine& wall = walls[static_cast<std::size_t>(w)];
    bool met = on_wall(line.a, w) || on_wall(line.b, w);
    const Vec<2> along = at(line.b) - at(line.a);
    for (const int corner : {wall.a, wall.b}) {
        if (corner == line.a || corner == line.b || !(distance(corner, line) <= reach_)) continue;
        met = true;
        met_[static_cast<std::size_t>(corner) - diagram_.vertices.size()] = 1;
        if (std::none_of(line.marks.begin(), line.marks.end(), [&](const auto& mark) { return mark.point == corner; }))
            line.marks.push_back({foot(at(corner), at(line.a), at(line.b)), corner});
    }
    if (met || !cross_each_other(at(line.a), at(line.b), at(wall.a), at(wall.b))) return;
    const Vec<2> whole = at(wall.b) - at(wall.a), to_line = at(line.a) - at(wall.a);
    const double t = std::clamp(cross_product(to_line, along) / cross_product(whole, along), 0.0, 1.0);
    const int point = add_point(at(wall.a) + t * whole, w);
    wall.marks.push_back({t, point});
    line.marks.push_back({foot(at(point), at(line.a), at(line.b)), point});
}

/// Whether edges of the diagram meet a hole fewer than twice: then it lies in one cell, which goes all around it.
bool Contacts::isolated(int first, int end) const {
    std::size_t meetings = 0;
    for (auto w = static_cast<std::size_t>(first); w < static_cast<std::size_t>(end); ++w)
        meetings += walls[w].marks.size() + static_cast<std::size_t>(met_[w]);
    return meetings < 2;
}

void Contacts::add_bridges(const Polygon& domain) {
    int first = static_cast<int>(domain.outer().size());
    std::vector<std::pair<int, int>> holes;  // before the first bridge adds meetings
    for (std::size_t o = 1; o < domain.outlines().size(); ++o) {
        const int end = first + static_cast<int>(domain.outlines()[o].size());
        if (isolated(first, end)) holes.emplace_back(first, end);
        first = end;
    }
    for (const auto& [from, end] : holes)
        for (const double direction : {-1.0, 1.0}) {
            int extreme = walls[static_cast<std::size_t>(from)].a;
            for (int w = from; w < end; ++w)
                if (const int corner = walls[static_cast<std::size_t>(w)].a; direction * (at(corner)[0] - at(extreme)[0]) > 0)
                    extreme = corner;
            bridge(extreme, direction);
        }
}

/// Looks from a corner to the left (direction -1) or right.
void Contacts::bridge(int corner, double direction) {
    const int cell = home_[static_cast<std::size_t>(corner) - diagram_.vertices.size()];
    const Vec<2> eye = at(corner);
    MarkedLine* hit = nullptr;
    double nearest = Bounds::inf, x_hit = 0;
    int hit_kind = free_point;
    const auto look = [&](MarkedLine& line, int kind) {
        if (line.a == corner || line.b == corner) return;
        const Vec<2>&a = at(line.a), &b = at(line.b);
        if (std::min(a[1], b[1]) > eye[1] + reach_ || std::max(a[1], b[1]) < eye[1] - reach_) return;
        const double t = a[1] == b[1] ? (direction * (a[0] - b[0]) < 0 ? 0.0 : 1.0) : std::clamp((eye[1] - a[1]) / (b[1] - a[1]), 0.0, 1.0);
        const double x = a[0] + t * (b[0] - a[0]), away = direction * (x - eye[0]);
        const double behind = kind == free_point ? reach_ : 0;  // of a side along a wall, the wall is met
        if (away > 0 && away < nearest - behind) nearest = away, x_hit = x, hit = &line, hit_kind = kind;
    };
    for (const int w : walls_of[static_cast<std::size_t>(cell)]) look(walls[static_cast<std::size_t>(w)], w);
    for (int k = 0; k < diagram_.count(cell); ++k)
        if (const auto found = side_of_.find(pair_key(cell, diagram_.edge(cell, k).beyond)); found != side_of_.end())
            look(sides[static_cast<std::size_t>(found->second)].line, free_point);
    if (hit) land(corner, cell, *hit, x_hit, hit_kind);
}

/// Ends a bridge on a line, at a point that is there or at a new one.
void Contacts::land(int corner, int cell, MarkedLine& line, double x, int kind) {
    const Vec<2> there(x, at(corner)[1]);
    for (const int point : chain(line))
        if ((at(point) - there).norm() <= reach_) {
            bridges.push_back({corner, point, cell});
            return;
        }
    const double t = foot(there, at(line.a), at(line.b));
    const int point = add_point(at(line.a) + t * (at(line.b) - at(line.a)), kind);
    line.marks.push_back({t, point});
    bridges.push_back({corner, point, cell});
}

const CellSide* Contacts::side(int i, int j) const {
    const auto found = side_of_.find(pair_key(i, j));
    return found == side_of_.end() ? nullptr : &sides[static_cast<std::size_t>(found->second)];
}

std::vector<int> Contacts::chain(const MarkedLine& line) {
    std::vector<int> all{line.a};
    for (const auto& mark : line.marks) all.push_back(mark.point);
    all.push_back(line.b);
    return all;
}

}  // namespace mpm
