/// What a scene is made of whose bodies are tessellated into particle domains.
#pragma once
#include <memory>
#include <vector>

#include "lab/triangles.hpp"

namespace mpm {

/// One tessellation for each body, its cells counter-clockwise. `assemble_domains` (chapters/cpdi/tessellated.hpp) fills it in by the
/// scene's tessellate(shape, cells, ppc), so that particles and weighting functions have the same domains.
struct Tessellated {
    std::shared_ptr<const std::vector<PolygonCells>> domains = {};

    /// One particle in each domain, at its centroid and with its area; `set(point)` gives it what else it needs.
    template <class Point, class Set> std::vector<std::vector<Point>> bodies_of(double rho, Set&& set) const {
        std::vector<std::vector<Point>> all;
        for (const PolygonCells& cells : *domains) {
            all.push_back(particles_at_centroids<Point>(cells, rho));
            for (Point& p : all.back()) set(p);
        }
        return all;
    }
};

}  // namespace mpm
