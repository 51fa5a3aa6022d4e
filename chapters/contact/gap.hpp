/// Whether the faces of two bodies have met at a shared node. As printed (5.2) the velocities alone tell, up to a cell too early.
#pragma once
#include <algorithm>
#include <limits>

#include "chapters/contact/normals.hpp"

namespace mpm {

/// Distance of the faces along n, from side a to side b, negative where they overlap: velocity: none, always closed. position: between the
/// mean positions of their masses, less `reach` cells, for these lie inside the bodies by about 0.4 of a cell each (Nairn 2013). extent:
/// between the outermost ends of the particles near the node.
template <int D>
double gap_between(const SharedNodes<D>& shared, const SharedNode<D>& node, const Side<D>& a, const Side<D>& b, const RigidWall<D>* wall,
                   const Vec<D>& n, const ContactChoice& choice, double t) {
    const double h = shared.lattice().h().cwiseProduct(n).norm();
    const bool plane = wall && wall->plane();
    const double ground = plane ? wall->height(node.x, t) : 0;  // of the node above a plane
    switch (choice.test()) {
        case ContactChoice::Gap::velocity:
            return -std::numeric_limits<double>::infinity();
        case ContactChoice::Gap::position:
            return plane ? ground + a.x.dot(wall->normal) - 0.5 * choice.reach * h : (b.x - a.x).dot(n) - choice.reach * h;
        case ContactChoice::Gap::extent:
            break;
    }
    double top = -std::numeric_limits<double>::infinity(), bottom = -top;
    for (const CloudPoint<D>& p : cloud(shared, a)) top = std::max(top, p.x.dot(n) + p.extent(n));
    if (plane) return ground - top;  // n points into the wall
    for (const CloudPoint<D>& p : cloud(shared, b)) bottom = std::min(bottom, p.x.dot(n) - p.extent(n));
    return bottom - top;
}

}  // namespace mpm
