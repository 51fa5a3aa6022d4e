/// Normals on the nodes around a disk that fits a hole (review 5.1.3, figures 46 and 47): both bodies' own by each way, and the pair's.
#pragma once
#include <array>
#include <cmath>
#include <algorithm>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "chapters/contact/bardenhagen.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/point.hpp"
#include "chapters/material/linear_elastic.hpp"
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/fill.hpp"

namespace mpm {

struct NormalsSettings {
    int cells = 10, ppc = 2;                        // over the disk's diameter
    double radius = 0.5, offset_x = 0, offset_y = 0;  // shift of the disk against the grid [cells]
    double ratio = 1;                               // density of the disk over that around it
    std::string placing = "cells", beside = "hole";
};

/// On one node. Angles in degrees; nan where the way gives none.
struct NodeNormals {
    Vec<2> x, exact;                                      // position; outwards of the disk
    Vec<2> own = Vec<2>::Zero(), other = Vec<2>::Zero(), common = Vec<2>::Zero();  // disk's own, the other body's, the pair's
    static double angle(const Vec<2>& a, const Vec<2>& b) {
        const double size = a.norm() * b.norm();
        if (!(size > 0)) return std::numeric_limits<double>::quiet_NaN();
        return std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b))) * 180 / std::numbers::pi;
    }
    double error_own() const { return angle(own, exact); }
    double error_common() const { return angle(common, exact); }
    double non_collinear() const { return angle(own, Vec<2>(-other)); }
};

/// All shared nodes, by one way of making normals.
inline std::vector<NodeNormals> normals_around(const NormalsSettings& s, const std::string& way) {
    using Shape = Tensor<2, Hat>;
    using Disc = Body<2, Point<2>, Node<2>, LinearElastic, Shape, Flip>;
    const double h = 2 * s.radius / s.cells;
    const int pad = 3;
    const Lattice<2> lattice(Vec<2>::Constant(-pad * h), Vec<2>::Constant(h), {s.cells + 2 * pad, s.cells + 2 * pad});
    const Vec<2> centre = Vec<2>::Constant(s.radius) + h * Vec<2>(s.offset_x, s.offset_y);
    const Disk disk{centre, s.radius};
    const Box all{lattice.origin() + Vec<2>::Constant(h), lattice.upper() - Vec<2>::Constant(h)};
    const Box slab{all.low, Vec<2>(all.high[0], centre[1] - s.radius)};
    std::vector<Disc> bodies;
    for (const bool inner : {true, false}) {
        std::vector<Point<2>> points =
            !inner ? (s.beside == "hole" ? particles_inside<Point<2>>(all - disk, lattice, middles(s.ppc), 1)
                                         : particles_inside<Point<2>>(slab, lattice, middles(s.ppc), 1))
                   : s.placing == "rings" ? rings<Point<2>>(centre, s.radius, h / s.ppc, s.ratio)
                                          : particles_inside<Point<2>>(disk, lattice, middles(s.ppc), s.ratio);
        bodies.push_back(Disc{{points, Grid<2, Node<2>>(lattice), {}}, Shape{lattice, {}}, Flip{}});
        scatter(bodies.back(), [](const auto& p, const auto& weights) {
            for (const auto& [node, phi, grad] : weights) node.m += phi * p.m;
        });
    }
    ContactChoice choice;
    choice.normals = way;
    SharedNodes<2> shared;
    shared.find(bodies, {}, 0);
    shared.measure(bodies, {}, choice, 0);
    std::vector<NodeNormals> result;
    for (const SharedNode<2>& node : shared.nodes) {
        const std::span<Side<2>> sides = shared.of(node);
        const Vec<2> exact = s.beside == "hole" ? Vec<2>((node.x - centre).normalized()) : Vec<2>(0, -1);
        NodeNormals& at = result.emplace_back(NodeNormals{node.x, exact});
        at.common = common_normal<2>(shared, sides[0], sides[1], nullptr, choice.kind());
        at.own = way == "regression" ? at.common : own_normal(sides[0]);
        at.other = way == "regression" ? Vec<2>(-at.common) : own_normal(sides[1]);
    }
    return result;
}

/// Mean and largest value over the nodes.
struct MeanMost {
    double mean = 0, most = 0;
};
inline MeanMost over(const std::vector<NodeNormals>& all, double (NodeNormals::*value)() const) {
    MeanMost sum;
    for (const NodeNormals& at : all)
        sum.mean += (at.*value)() / static_cast<double>(all.size()), sum.most = std::max(sum.most, (at.*value)());
    return sum;
}

}  // namespace mpm
