/// A body {points, grid, law, shape, transfer} and the two sweeps over its particles that every scheme is written with.
#pragma once
#include <cstddef>
#include <vector>

#include "lab/grid.hpp"
#include "lab/stencil.hpp"

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
};

/// One body. `Shape` is called with (particle, its number) and gives a stencil; `Transfer` says how particles and nodes exchange velocities, and
/// extends both by what it needs.
template <int Dim, class PointType, class NodeType, class LawType, class ShapeType, class TransferType>
struct Body : Matter<Dim, PointType, NodeType, LawType> {
    using Shape = ShapeType;
    using Transfer = TransferType;

    Shape shape;
    Transfer transfer;
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

/// Visits every particle with its weights; the visitor may write to the nodes: `scatter(body, [](auto& p, const auto& weights)
/// {...})`. A particle outside the grid throws OutsideGrid.
template <class Body, class Visit> void scatter(Body& body, Visit&& visit) {
    auto* nodes = &*body.grid.begin();
    if constexpr (goes_by_corners<typename Body::Shape>) {
        body.shape.corners().from_grid(body.grid, body.corner_nodes);
        nodes = body.corner_nodes.data();
    }
    for (std::size_t i = 0; i < body.points.size(); ++i) {
        const auto& stencil = body.shape(body.points[i], i);
        visit(body.points[i], Weights{stencil, nodes});
    }
    if constexpr (goes_by_corners<typename Body::Shape>) body.shape.corners().to_grid(body.corner_nodes, body.grid);
}

/// Visits every particle with its weights; the visitor only reads the nodes.
template <class Body, class Visit> void gather(Body& body, Visit&& visit) {
    const auto* nodes = &*body.grid.begin();
    if constexpr (goes_by_corners<typename Body::Shape>) {
        body.shape.corners().from_grid(body.grid, body.corner_nodes);
        nodes = body.corner_nodes.data();
    }
    for (std::size_t i = 0; i < body.points.size(); ++i) {
        const auto& stencil = body.shape(body.points[i], i);
        visit(body.points[i], Weights{stencil, nodes});
    }
}

}  // namespace mpm
