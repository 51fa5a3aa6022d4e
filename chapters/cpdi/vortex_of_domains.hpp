/// The generalized vortex of vortex.hpp tessellated into particle domains (review 6.2.3, figures 72 and 73).
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "chapters/cpdi/tessellated.hpp"
#include "chapters/mms/vortex.hpp"
#include "lab/structured.hpp"

namespace mpm {

/// Updated-Lagrangian. `conforming` domains are polar, their corners on the circles of the ring's edges; others are boxes of the grid whose
/// middles lie in the ring, which they cover in steps.
struct VortexOfDomains : Vortex<false>, Tessellated {
    static constexpr const char* name = "vortex-of-domains";
    bool conforming = true;

    VortexOfDomains(const VortexCase& options, bool polar) : Vortex<false>(options), conforming(polar) {}

    /// About ppc x ppc domains in a cell.
    std::vector<PolygonCells> tessellate(const std::string&, int cells, int ppc) const {
        const double size = 2 * R_o / cells / ppc;
        if (!conforming) return {boxes(cells * ppc)};
        const auto fitting = [&](double length) { return std::max(3, static_cast<int>(std::lround(length / size))); };
        const CellCounts counts{fitting(width()), fitting(2 * std::numbers::pi * middle())};
        return {polygon_cells(quadrilaterals_of(Ring{Vec<2>::Zero(), R_i, R_o}, counts))};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int, int) const {
        return bodies_of<Point>(rho, [this](Point& p) { p.v = v(p.X, 0); });
    }

private:
    PolygonCells boxes(int n) const {
        const PolygonCells all = polygon_cells(quadrilaterals_of(Box{Vec<2>::Constant(-R_o), Vec<2>::Constant(R_o)}, {n, n}));
        PolygonCells ring{all.points, {}};
        for (std::size_t i = 0; i < all.corners.size(); ++i) {
            const double R = cell_moments(all.points, all.corners[i], i).centroid.norm();
            if (R >= R_i && R <= R_o) ring.corners.push_back(all.corners[i]);
        }
        if (ring.corners.empty()) throw BadInput("--cells, --ppc, --inner, --outer: no box lies inside the ring");
        return ring;
    }
};

}  // namespace mpm
