/// APIC, the affine particle-in-cell transfer (Jiang et al. 2015): a particle carries the gradient C of the velocity about it and gives
/// each node v + C (x_I - x_p). Takes velocities back as PIC does, yet keeps what PIC smears: linear fields and angular momentum.
#pragma once
#include "chapters/explicit/point.hpp"

namespace mpm {

/// `TotalLagrangian`: the grid belongs to the initial positions X, else to x.
template <bool TotalLagrangian> struct Apic {
    static constexpr const char* name = "apic";
    template <class Base> struct PointOf : Base {
        Mat<Base::D> C = Mat<Base::D>::Zero();  // affine velocity gradient [1/time]
    };
    template <class Base> struct NodeOf : Base {
        Vec<Base::D> x = Vec<Base::D>::Zero();  // position, told by the grid
        static constexpr auto fields() { return std::tuple_cat(Base::fields(), std::tuple(&NodeOf::x)); }
    };

    template <class Point> static const auto& place(const Point& p) {
        if constexpr (TotalLagrangian)
            return p.X;
        else
            return p.x;
    }

    template <class Point, class Node> Vec<Node::D> velocity(const Point& p, const Node& node) const {
        return p.v + p.C * (node.x - place(p));
    }

    template <class Body, class Fix> void nodal_velocities(Body& body, Fix&& fix) const { mapped_velocities(body, fix); }
    template <class Body, class Fix> void mapped_velocities(Body& body, Fix&&) const {
        each(body.grid, [&](auto& node) { node.v_new = mpm::velocity(node.mv_new, node.m); });
    }

    /// v = sum phi v_I, C = [sum phi v_I (x_I - x_p)^T] [sum phi (x_I - x_p)(x_I - x_p)^T]^-1. The second matrix is diagonal, since the
    /// functions are products that reproduce linear fields along each axis. Where it vanishes, at a node with hat functions, C is the
    /// limit, sum v_I grad^T.
    template <class Point, class Weights> void update_velocity(Point& p, const Weights& weights) const {
        constexpr int D = Point::D;
        Vec<D> v = Vec<D>::Zero(), spread = Vec<D>::Zero();
        Mat<D> B = Mat<D>::Zero(), L = Mat<D>::Zero();
        for (const auto& [node, phi, grad] : weights) {
            const Vec<D> r = node.x - place(p);
            v += phi * node.v_new;
            B += phi * node.v_new * r.transpose();
            L += node.v_new * grad.transpose();
            spread += phi * r.cwiseAbs2();
        }
        p.v = v;
        for (int d = 0; d < D; ++d) p.C.col(d) = spread[d] > 0 ? Vec<D>(B.col(d) / spread[d]) : Vec<D>(L.col(d));
    }

    template <class Point, class Velocity> const Velocity& moving(const Point&, const Velocity& v) const { return v; }
};

}  // namespace mpm
