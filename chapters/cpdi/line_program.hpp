/// The common part of cpdi_bar and cpdi_segment: CPDI-L2 in one dimension (l2.hpp), its corners moved by the grid or carried by F.
#pragma once
#include <string>
#include <vector>

#include "chapters/cpdi/domains.hpp"
#include "chapters/cpdi/l2.hpp"
#include "chapters/cpdi/parallelograms.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/usl.hpp"
#include "lab/assemble.hpp"

namespace mpm {

/// What the command line says besides the scene.
struct LineSettings {
    Common common;
    std::string scheme = "usl", corners = "grid";

    void declare(Options& o) {
        o.choice("scheme", scheme, {"usl", "musl"}, "method");
        o.choice("corners", corners, {"grid", "F"}, "ends of domains move with the grid (3.38), or are at x -+ F l0/2: cpGIMP's domains");
    }
};

/// A lattice with one more cell before its first one and, if told, one behind its last: rounding may take a corner at a held end past it.
inline Lattice<1> with_ends(const Lattice<1>& inner, bool behind) {
    return {inner.origin() - inner.h(), inner.h(), {inner.cells(0) + (behind ? 2 : 1)}, inner.per_cell()};
}

/// Domains of particles that tile a line, neighbours with a common end: domain i has the corners i and i + 1.
template <class Points> Domains<DomainL2, false> chain_of(const Lattice<1>& lattice, const Points& points) {
    std::vector<Vec<1>> corners{Vec<1>(points.front().X[0] - points.front().V0 / 2)};
    Domains<DomainL2, false>::Of of;
    for (const auto& p : points) {
        const int c = static_cast<int>(corners.size());
        of.push_back({c - 1, c});
        corners.push_back(Vec<1>(p.X[0] + p.V0 / 2));
    }
    return {lattice, std::move(corners), std::move(of)};
}

template <class Scheme, class Scene> Assembled assemble_line(const Scheme& scheme, const Scene& scene, const LineSettings& s, int cells) {
    const ShapeFacts facts{DomainL2::name, 1, 2};
    if (s.corners == "grid")
        return assemble<Domains<DomainL2, false>>(scheme, scene, Flip{}, facts, cells, s.common,
                                                  [](const auto& lattice, const auto& points) { return chain_of(lattice, points); });
    const auto carried = [](const auto& lattice, const auto& points) {
        std::vector<Vec<1>> half;
        for (const auto& p : points) half.emplace_back(p.V0 / 2);
        return Parallelograms<DomainL2, false>(lattice, points, std::move(half));
    };
    return assemble<Parallelograms<DomainL2, false>>(scheme, scene, Flip{}, facts, cells, s.common, carried);
}
template <class Scene> Assembled assemble_line(const Scene& scene, const LineSettings& s, int cells) {
    return s.scheme == "usl" ? assemble_line(Usl{}, scene, s, cells) : assemble_line(Musl{}, scene, s, cells);
}

}  // namespace mpm
