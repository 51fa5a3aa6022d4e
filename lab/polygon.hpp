/// A simple polygon with holes as a region (lab/geometry.hpp), for many corners and many points.
#pragma once
#include <string>
#include <vector>

#include "lab/geometry.hpp"

namespace mpm {

/// Corners in order, either way round; the last is joined to the first [length].
using Outline = std::vector<Vec<2>>;

/// Area enclosed, > 0 counterclockwise, < 0 clockwise [length^2].
double signed_area(const Outline& outline);
/// n corners on a circle, counterclockwise from the right.
Outline circle(const Vec<2>& centre, double r, int n);

/// Inside the outer outline and in no hole. Of polygons that share an edge exactly one holds a point of it: for a rectangle, the left and
/// lower edges belong to it. A query takes O(log^2 n), memory O(n log n).
class Polygon {
public:
    /// Throws BadInput, naming the outline and its corners (counted from 1), unless each outline has at least three corners of finite
    /// numbers and encloses an area, no corner is there twice, no outline crosses or touches itself or another, and the holes lie in the
    /// outer one and not in each other. Without rounding error, in O(n log n) for n corners.
    explicit Polygon(Outline outer, std::vector<Outline> holes = {});

    bool inside(const Vec<2>& x) const;
    Bounds bounds() const { return bounds_; }
    double area() const;       // [length^2]
    double perimeter() const;  // with that of the holes [length]
    const Outline& outer() const { return outlines_.front(); }
    const std::vector<Outline>& outlines() const { return outlines_; }  // the outer one, then the holes

private:
    struct Edge {
        Vec<2> low, high;  // by y
        /// Where it is at height y, the same for both directions of the edge.
        double x(double y) const { return low[0] + (y - low[1]) * ((high[0] - low[0]) / (high[1] - low[1])); }
    };
    void build();
    void check_holes() const;

    std::vector<Outline> outlines_;
    Bounds bounds_;
    std::vector<double> levels_;  // heights of corners, from low to high, each once
    /// A binary tree over the slabs between levels: each edge stands in the few nodes whose slabs it crosses whole. Edges do not cross, so
    /// that those of a node have an order from left to right.
    std::vector<std::vector<Edge>> tree_;
};

namespace detail {
/// What the polygon promises of its outlines, the outer one first, but for where the holes lie. Throws BadInput.
void check_outlines(const std::vector<Outline>& outlines);
}  // namespace detail

/// Reads a polygon: a line `x, y` or `x y` for each corner, an empty line before each hole; `#` starts a comment, and a last corner
/// that repeats the first is left out. Throws FileTrouble for what cannot be read, with the line, and BadInput as Polygon does.
Polygon read_polygon(const std::string& path);

}  // namespace mpm
