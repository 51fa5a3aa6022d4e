/// Normals on shared nodes (review 5.1.3): of each body alone, as printed, or one for a pair, so that its momentum is conserved.
#pragma once
#include <span>

#include "chapters/contact/regression.hpp"

namespace mpm {

/// The body's own normal, outwards: of its gradient of mass (5.12), volume or cell density (5.11). Zero where it has none.
template <int D> Vec<D> own_normal(const Side<D>& side) {
    const double size = side.out.norm();
    return size > 0 ? Vec<D>(side.out / size) : Vec<D>(Vec<D>::Zero());
}

template <int D> std::span<const CloudPoint<D>> cloud(const SharedNodes<D>& shared, const Side<D>& side) {
    return {shared.particles.data() + side.first, side.count};
}

/// The pair's common normal, from side a to side b; zero where none can be told. A plane knows its own. Gradients count by what they weigh:
/// the difference of both, in which a wall, whose mass is infinite, has the only say.
template <int D>
Vec<D> common_normal(const SharedNodes<D>& shared, const Side<D>& a, const Side<D>& b, const RigidWall<D>* wall,
                     ContactChoice::Normals kind) {
    if (wall && wall->plane()) return -wall->normal;
    if (kind == ContactChoice::Normals::regression) return parting_normal<D>(cloud(shared, a), cloud(shared, b), shared.lattice().per_h());
    const Vec<D> n = wall ? Vec<D>(-b.out) : Vec<D>(a.out - b.out);
    const double size = n.norm();
    return size > 0 ? Vec<D>(n / size) : Vec<D>(Vec<D>::Zero());
}

}  // namespace mpm
