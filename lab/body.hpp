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
};

/// Visits every particle with its weights; the visitor may write to the nodes: `scatter(body, [](auto& p, const auto& weights)
/// {...})`. A particle outside the grid throws OutsideGrid.
template <class Body, class Visit> void scatter(Body& body, Visit&& visit) {
    auto* nodes = &*body.grid.begin();
    for (std::size_t i = 0; i < body.points.size(); ++i) {
        const auto& stencil = body.shape(body.points[i], i);
        visit(body.points[i], Weights{stencil, nodes});
    }
}

/// Visits every particle with its weights; the visitor only reads the nodes.
template <class Body, class Visit> void gather(Body& body, Visit&& visit) {
    const auto* nodes = &*body.grid.begin();
    for (std::size_t i = 0; i < body.points.size(); ++i) {
        const auto& stencil = body.shape(body.points[i], i);
        visit(body.points[i], Weights{stencil, nodes});
    }
}

}  // namespace mpm
