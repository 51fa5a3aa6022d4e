/// Pressure on the edges of particle domains (review 4.2.3, equation 4.6): the loaded boundary is where it is, not half a particle inside.
#pragma once
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "chapters/cpdi/domain.hpp"
#include "lab/triangles.hpp"

namespace mpm {

/// A loaded edge: numbers of its corners, which see the body on their left, and its outward normal, as long as it, at the start [length].
struct LoadedEdge {
    std::size_t from, to;
    Vec<2> N;
};

/// The edges of a mesh whose cells run counter-clockwise that belong to one cell only and both of whose ends `where` holds.
template <class Where> std::vector<LoadedEdge> boundary_edges(const PolygonCells& mesh, Where&& where) {
    std::map<std::pair<int, int>, int> cells;
    const auto each_edge = [&](auto&& visit) {
        for (const std::vector<int>& cell : mesh.corners)
            for (std::size_t c = 0; c < cell.size(); ++c) visit(cell[c], cell[(c + 1) % cell.size()]);
    };
    each_edge([&](int a, int b) { ++cells[std::minmax(a, b)]; });
    std::vector<LoadedEdge> edges;
    each_edge([&](int a, int b) {
        const auto from = static_cast<std::size_t>(a), to = static_cast<std::size_t>(b);
        if (cells[std::minmax(a, b)] > 1 || !where(mesh.points[from]) || !where(mesh.points[to])) return;
        edges.push_back({from, to, edge_normal(mesh.points[from], mesh.points[to])});
    });
    return edges;
}

/// Force on an edge under the pressure p [stress]: as it was at the start, or on the edge as it is now.
struct DeadPressure {
    double p;
    Vec<2> operator()(const LoadedEdge& edge, const Vec<2>&, const Vec<2>&) const { return -p * edge.N; }
};
struct FollowerPressure {
    double p;
    Vec<2> operator()(const LoadedEdge&, const Vec<2>& from, const Vec<2>& to) const { return -p * edge_normal(from, to); }
};

/// Calls visit(node, force) for what the edges give to the grid: half of its force acts at each end of an edge, the integral of the end's
/// function along it, and goes on by the hat functions there. `corners` are those of the domains (Corners), `force` one of the above.
template <class Corners, class Force, class Visit>
void each_edge_force(const std::vector<LoadedEdge>& edges, const Corners& corners, const Force& force, Visit&& visit) {
    for (const LoadedEdge& edge : edges) {
        const Vec<2> half = force(edge, corners[edge.from], corners[edge.to]) / 2;
        for (const std::size_t end : {edge.from, edge.to}) corners.hats(end, [&](int I, double N) { visit(I, Vec<2>(N * half)); });
    }
}

}  // namespace mpm
