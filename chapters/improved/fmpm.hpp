/// FMPM(k) and XPIC(k) (Nairn and Hammerquist 2021; Hammerquist and Nairn 2017): PIC with the lumped inverse of the mass matrix replaced by
/// k terms of the series for the inverse of the full one.
#pragma once
#include "chapters/explicit/point.hpp"
#include "lab/body.hpp"

namespace mpm {

/// v(k) = sum_{l < k} (I - S+ S)^l v(1): S interpolates to the particles, S+ = m^-1 S^T M maps back, v(1) = mv/m. k = 1 is PIC.
/// FMPM: the series acts on the velocity at t + dt. XPIC: it acts on the velocity at t, and the lumped acceleration is added.
/// Particles move with the grid. (The papers move them with the mean of their old and new velocities; those are half a step before and
/// after t here, so that x would lag by half a step: first order in dt, measured on the manufactured segment.)
struct Fmpm {
    int order = 2;      // k, number of terms [-]
    bool whole = true;  // false: XPIC
    const char* name = "fmpm";

    template <class Point> using PointOf = Point;
    template <class Base> struct NodeOf : Base {
        Vec<Base::D> term = Vec<Base::D>::Zero(), mapped = Vec<Base::D>::Zero();  // one term of the series; its S^T M S, a momentum
        static constexpr auto sums() { return std::tuple_cat(Base::sums(), std::tuple(&NodeOf::mapped)); }
        static constexpr auto fields() { return std::tuple_cat(Base::fields(), std::tuple(&NodeOf::term)); }
    };

    template <class Point, class Node> const auto& velocity(const Point& p, const Node&) const { return p.v; }

    template <class Body, class Fix> void nodal_velocities(Body& body, Fix&& fix) const {
        using Node = typename Body::Node;
        if (whole) {
            sum(body, &Node::mv_new, &Node::v_new, fix);
        } else {
            sum(body, &Node::mv, &Node::v, fix);
            each(body.grid, [&](auto& node) { node.v_new = node.v + mpm::velocity<Body::D>(node.mv_new - node.mv, node.m); });
        }
    }
    template <class Body, class Fix> void mapped_velocities(Body& body, Fix&& fix) const {
        using Node = typename Body::Node;
        sum(body, &Node::mv_new, &Node::v_new, fix);
    }

    template <class Point, class Weights> void update_velocity(Point& p, const Weights& weights) const {
        p.v.setZero();
        for (const auto& [node, phi, grad] : weights) p.v += phi * node.v_new;
    }

    template <class Point, class Velocity> const Velocity& moving(const Point&, const Velocity& v) const { return v; }

private:
    /// The incremental loop. A held velocity takes no term beyond the first: later ones would grow with k.
    template <class Body, class Momentum, class Velocity, class Fix> void sum(Body& body, Momentum mv, Velocity v, Fix&& fix) const {
        using Node = typename Body::Node;
        constexpr int D = Body::D;
        each(body.grid, [&](auto& node) { node.term = node.*v = mpm::velocity(node.*mv, node.m); });
        for (int l = 1; l < order; ++l) {
            each(body.grid, [&](auto& node) { node.mapped = Vec<D>::Zero(); });
            scatter(body, [](const auto& p, const auto& weights) {
                Vec<D> at_p = Vec<D>::Zero();
                for (const auto& [node, phi, grad] : weights) at_p += phi * node.term;
                for (const auto& [node, phi, grad] : weights) node.mapped += phi * p.m * at_p;
            });
            each(body.grid, [&](auto& node) {
                node.mapped = node.m * (node.*v + node.term) - node.mapped;  // the sum with its next term, as a momentum
            });
            fix(&Node::mapped);
            each(body.grid, [&](auto& node) {
                node.term = mpm::velocity<D>(node.mapped - node.m * node.*v, node.m);
                node.*v += node.term;
            });
        }
    }
};

inline Fmpm xpic(int order) { return {order, false, "xpic"}; }

}  // namespace mpm
