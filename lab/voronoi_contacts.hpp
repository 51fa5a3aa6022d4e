/// Where the edges of a Voronoi diagram meet the outlines of a polygon, each meeting point made once: the first half of clipping the cells
/// (lab/voronoi_clip.hpp).
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lab/polygon.hpp"
#include "lab/voronoi_diagram.hpp"

namespace mpm {

/// What may move a point: nothing that stands at a corner of the polygon; one on a wall stays there, whose number it has (>= 0).
inline constexpr int free_point = -1, fixed_point = -2;

/// A straight line between two points, and the points met on it at 0 < t < 1.
struct MarkedLine {
    struct Mark {
        double t;
        int point;
    };
    int a, b;
    std::vector<Mark> marks;
};
struct CellSide {
    int left, right;  // seeds of the cells on both sides, seen from a to b
    MarkedLine line;
};
/// A cut from a hole that lies in one cell to whatever is to its left or right.
struct Bridge {
    int from, to, seed;
};

/// Undirected edges by the numbers of their ends.
inline std::uint64_t pair_key(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

/// Meetings within `reach` count as one: a vertex of the diagram so near to a wall moves onto it, an edge that passes a corner so near goes
/// through it. Beyond, signs are exact. So walls along edges and through vertices need no cases of their own.
class Contacts {
public:
    Contacts(const VoronoiDiagram& diagram, const Polygon& domain, double reach);

    std::vector<Vec<2>> points;              // vertices of the diagram, corners of the polygon, crossings [length]
    std::vector<int> kinds;                  // of each point: free_point, fixed_point or its wall
    std::vector<int> place;                  // point that stands for a vertex of the diagram
    std::vector<MarkedLine> walls;           // edges of the outlines, the polygon on their left
    std::vector<std::vector<int>> walls_of;  // the walls that touch each cell
    std::vector<CellSide> sides;             // edges of touched cells, each once
    std::vector<Bridge> bridges;

    bool touched(int cell) const { return !walls_of[static_cast<std::size_t>(cell)].empty(); }
    /// The side between two cells, or nullptr if neither is touched or they do not meet.
    const CellSide* side(int i, int j) const;
    /// Whether both points are on one wall: what joins them runs along it.
    bool along_wall(int p, int q) const;
    /// The points of a line in order, both ends with it.
    static std::vector<int> chain(const MarkedLine& line);

private:
    const Vec<2>& at(int point) const { return points[static_cast<std::size_t>(point)]; }
    int& kind(int point) { return kinds[static_cast<std::size_t>(point)]; }
    int add_point(const Vec<2>& x, int kind);
    bool on_wall(int point, int wall) const;
    double distance(int point, const MarkedLine& line) const;
    bool close(const VoronoiEdge& from, const VoronoiEdge& to, const MarkedLine& wall) const;
    void build_walls(const Polygon& domain);
    void touch();
    void touch(int wall);
    void snap();
    void snap(int vertex, const std::vector<int>& near);
    void add_sides();
    void cross(MarkedLine& line, int wall);
    void add_bridges(const Polygon& domain);
    bool isolated(int first, int end) const;
    void bridge(int corner, double direction);
    void land(int corner, int cell, MarkedLine& line, double x, int kind);

    const VoronoiDiagram& diagram_;
    double reach_;
    std::vector<char> met_;   // corners that an edge of the diagram goes through
    std::vector<int> home_;   // cell of each corner
    std::vector<int> stamp_;  // the last wall that each cell was found to touch
    std::unordered_map<std::uint64_t, int> side_of_;
};

}  // namespace mpm
