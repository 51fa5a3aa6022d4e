/// A body {points, grid, law, shape, transfer} and the sweeps over its particles that every scheme is written with.
#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "lab/grid.hpp"
#include "lab/order.hpp"
#include "lab/stencil.hpp"
#include "lab/strips.hpp"

namespace mpm {

/// What one particle touches, as a range of {node, phi, grad}: `for (const auto& [node, phi, grad] : weights)`.
template <class Stencil, class Node> class Weights {
public:
    Weights(const Stencil& stencil, Node* nodes) : stencil_(stencil), nodes_(nodes) {}

    struct Entry {
        Node& node;
        const double phi;                                           // weight [-]
        const decltype(Stencil::value_type::grad)& grad;            // weighting gradient [1/length]
    };
    struct Iterator {
        const typename Stencil::value_type* entry;
        Node* nodes;
        Entry operator*() const { return {nodes[entry->node], entry->phi, entry->grad}; }
        Iterator& operator++() { return ++entry, *this; }
        bool operator!=(const Iterator& other) const { return entry != other.entry; }
    };
    Iterator begin() const { return {stencil_.data(), nodes_}; }
    Iterator end() const { return {stencil_.data() + stencil_.size(), nodes_}; }

private:
    const Stencil& stencil_;
    Node* nodes_;
};

/// A point as a law extends it by its history, e.g. a plastic strain: Law::PointOf<Base>, if the law has one.
template <class Law, class Base> struct WithHistory {
    using Point = Base;
};
template <class Law, class Base>
    requires requires { typename Law::template PointOf<Base>; }
struct WithHistory<Law, Base> {
    using Point = typename Law::template PointOf<Base>;
};

/// What a body is made of, without the weights: all that the monitor and the files need. `Law` is a constitutive model.
template <int Dim, class PointType, class NodeType, class LawType> struct Matter {
    static constexpr int D = Dim;
    using Point = PointType;
    using Node = NodeType;
    using Law = LawType;

    std::vector<Point> points;
    Grid<D, Node> grid;
    Law law;
    std::vector<std::uint32_t> numbers = {};  // of the points, their places at the start; empty while they are still there

    std::size_t number(std::size_t place) const { return numbers.size() == points.size() ? numbers[place] : place; }
    void number_points() {
        if (numbers.size() == points.size()) return;
        numbers.resize(points.size());
        std::iota(numbers.begin(), numbers.end(), std::uint32_t{0});
    }
};

/// One body. `Shape` is called with (particle, its place) and gives a stencil; `Transfer` says how particles and nodes exchange
/// velocities, and extends both by what it needs.
template <int Dim, class PointType, class NodeType, class LawType, class ShapeType, class TransferType>
struct Body : Matter<Dim, PointType, NodeType, LawType> {
    using Shape = ShapeType;
    using Transfer = TransferType;

    Shape shape;
    Transfer transfer;
    Strips strips = {};               // of several threads
    CellOrder<PointType> order = {};  // of the points, where they may change places
    std::vector<NodeType> corner_nodes = {};  // of shapes that go by corners (review appendix C)
};

/// The particles of all bodies one after the other, as a range with size() and [i].
template <class Matter> class AllPoints {
public:
    using Point = typename Matter::Point;
    explicit AllPoints(const std::vector<Matter*>& bodies) : bodies_(bodies) {}

    struct Iterator {
        const std::vector<Matter*>* bodies;
        std::size_t body, i;
        const Point& operator*() const { return (*bodies)[body]->points[i]; }
        Iterator& operator++() {
            ++i;
            return settle();
        }
        bool operator!=(const Iterator& other) const { return body != other.body || i != other.i; }
        Iterator& settle() {  // past the ends of bodies
            while (body < bodies->size() && i == (*bodies)[body]->points.size()) ++body, i = 0;
            return *this;
        }
    };
    Iterator begin() const { return Iterator{&bodies_, 0, 0}.settle(); }
    Iterator end() const { return {&bodies_, bodies_.size(), 0}; }
    std::size_t size() const {
        std::size_t n = 0;
        for (const Matter* body : bodies_) n += body->points.size();
        return n;
    }
    const Point& operator[](std::size_t i) const {
        std::size_t body = 0;
        while (i >= bodies_[body]->points.size()) i -= bodies_[body++]->points.size();
        return bodies_[body]->points[i];
    }

private:
    const std::vector<Matter*>& bodies_;
};

/// Whether the stencils of a shape count corners of domains, through which it reaches the grid.
template <class Shape> constexpr bool goes_by_corners = requires(const Shape& shape) { shape.corners(); };

/// Moves what belongs to the weighting function with the grid, e.g. corners of domains (review 3.38); most have nothing to move.
template <class Body> void follow(Body& body, double dt) {
    if constexpr (requires { body.shape.follow(body, dt); }) body.shape.follow(body, dt);
}

/// Laws that need all particles of a body after the update of their F (F-bar: averages over cells) update the stresses here, others one by
/// one as the schemes go through the particles.
template <class Body> constexpr bool updates_together = requires(Body& body) { body.law.update_together(body); };
template <class Body> void update_together(Body& body) {
    if constexpr (updates_together<Body>) body.law.update_together(body);
}

namespace detail {
/// Shapes that say how many node rows they touch (`rows`, counted from that of the first entry) can be swept by several threads. Others
/// may keep anything, and one thread sweeps them.
template <class Body> constexpr bool shares_sweeps = Body::D == 2 && requires { Body::Shape::rows; };

/// The loop over some particles, with the visit in it: calls would cost as much as what they do. Compiled once, for one thread and for
/// several. Returns the number of strays.
template <class Body, class Node, class Visit>
[[gnu::noinline, gnu::flatten]] std::uint32_t visit_part(Body& body, Node* nodes, Visit& visit, const Strips::Part& part) {
    std::uint32_t strays = 0;
    std::size_t k = part.begin;
    try {
        for (; k < part.end; ++k) {
            const std::size_t i = part.number(k);
            const auto& stencil = body.shape(body.points[i], i);
            if constexpr (shares_sweeps<Body>)
                if (!part.reach.holds(stencil[0].node)) [[unlikely]] {
                    part.strays[strays++] = static_cast<std::uint32_t>(i);
                    continue;
                }
            visit(body.points[i], Weights{stencil, nodes});
        }
    } catch (...) {
        if (!part.first) throw;
        part.first->caught(part.number(k));
    }
    return strays;
}

template <class Body, class Visit> void scatter_in_threads(Body& body, Visit& visit) {
    const int threads = body.grid.threads();
    const auto& lattice = body.grid.lattice();
    body.strips.prepare(body.points.size(), lattice.nodes(1), lattice.nodes(0), Body::Shape::rows, threads,
                        [&](std::size_t i) { return body.shape(body.points[i], i)[0].node; });
    body.strips.sweep(threads, [&](const Strips::Part& part) { return visit_part(body, &body.grid[0], visit, part); });
}
template <class Body, class Node, class Visit> void gather_in_threads(Body& body, Node* nodes, Visit& visit) {
    FirstThrown first;
    const auto parts = static_cast<std::size_t>(body.grid.threads());
    in_threads(body.grid.threads(), [&](int thread) {
        const std::size_t k = static_cast<std::size_t>(thread), n = body.points.size();
        Strips::Part part{n * k / parts, n * (k + 1) / parts};
        part.first = &first;
        visit_part(body, nodes, visit, part);
    });
    first.rethrow();
}
}  // namespace detail

/// Visits every particle with its weights, in one thread and one after the other: for visitors that write elsewhere than to the
/// particle and its nodes. A particle outside the grid throws OutsideGrid.
template <class Body, class Visit> void in_order(Body& body, Visit&& visit) {
    const Strips::Part all{0, body.points.size()};
    if constexpr (goes_by_corners<typename Body::Shape>) {
        body.shape.corners().from_grid(body.grid, body.corner_nodes);
        detail::visit_part(body, body.corner_nodes.data(), visit, all);
        body.shape.corners().to_grid(body.corner_nodes, body.grid);
    } else {
        detail::visit_part(body, &body.grid[0], visit, all);
    }
}

/// Visits every particle with its weights; the visitor may write to the particle and its nodes: `scatter(body, [](auto& p, const
/// auto& weights) {...})`. In as many threads as the grid was given, with the same sums each time. A particle outside the grid
/// throws OutsideGrid.
template <class Body, class Visit> void scatter(Body& body, Visit&& visit) {
    if constexpr (detail::shares_sweeps<Body>)
        if (body.grid.threads() > 1) return detail::scatter_in_threads(body, visit);
    in_order(body, visit);
}

/// The same for a visitor that only reads the nodes.
template <class Body, class Visit> void gather(Body& body, Visit&& visit) {
    const typename Body::Node* nodes = &body.grid[0];
    if constexpr (goes_by_corners<typename Body::Shape>) {
        body.shape.corners().from_grid(body.grid, body.corner_nodes);
        nodes = body.corner_nodes.data();
    }
    if constexpr (detail::shares_sweeps<Body>)
        if (body.grid.threads() > 1) return detail::gather_in_threads(body, nodes, visit);
    detail::visit_part(body, nodes, visit, {0, body.points.size()});
}

}  // namespace mpm
