/// The two disks of two_disks.hpp, tessellated into particle domains.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "chapters/cpdi/tessellated.hpp"
#include "chapters/scenes/two_disks.hpp"
#include "lab/polygon.hpp"
#include "lab/structured.hpp"

namespace mpm {

/// Both disks are one body: they feel each other through the one velocity field, as particles without domains do.
struct DisksOfDomains : TwoDisks<false>, Tessellated {
    static constexpr const char* name = "disks-of-domains";

    /// What needs a mesher: triangles of edges of this size in a polygon, and as many of its Voronoi cells.
    Triangles (*triangles)(const Outline& outline, double size) = nullptr;
    PolygonCells (*polygons)(const Outline& outline, long count) = nullptr;

    DisksOfDomains(const DiskSettings& settings, double until) {
        static_cast<DiskSettings&>(*this) = settings;
        t_end = until;
    }

    /// About ppc x ppc domains in a cell: boxes of the grid whose middles are inside, triangles cut into quadrilaterals, triangles, or
    /// polygons. The others' edges follow the circle.
    std::vector<PolygonCells> tessellate(const std::string& shape, int cells, int ppc) const {
        const double h = 1.0 / cells, size = h / ppc;
        const Vec<2> centre = Vec<2>::Constant(0.2 + offset * h);
        const long count = std::max(1L, std::lround(std::numbers::pi * std::pow(radius / size, 2)));
        if (count > detail::most_structured)
            throw BadInput("--cells, --ppc: a disk of " + std::to_string(count) + " domains: allowed at most " +
                           std::to_string(detail::most_structured));
        PolygonCells disk;
        if (shape == DomainR4::name) disk = boxes(centre, size);
        else if (shape == DomainQ4::name) disk = polygon_cells(quadrilaterals_of(triangles_about(centre, 3 * size * size)));
        else if (shape == DomainT3::name) disk = polygon_cells(triangles_about(centre, size * size));
        else disk = polygons(outline(centre, size), count);
        return {with_mirror(counter_clockwise(disk), h)};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int, int) const {
        auto all = bodies_of<Point>(rho, [](Point&) {});
        for (std::size_t i = 0; i < all[0].size(); ++i) all[0][i].v = Vec<2>::Constant(2 * i < all[0].size() ? v0 : -v0);
        return all;
    }

    /// The rebound: the largest kinetic energy after the least one, when the disks part. From then on they exchange energy with their own
    /// vibrations; what the centres keep does not change any more.
    struct Observer : TwoDisks<false>::Observer {
        double rebound = 0, centres = 0;  // kinetic energies: the largest after the least, that of the centres at the end

        explicit Observer(const DisksOfDomains& disks) : TwoDisks<false>::Observer{disks} {}
        template <class Points> void sample(const Points& points, double t, double energy) {
            const double least_before = least;
            TwoDisks<false>::Observer::sample(points, t, energy);
            double kinetic = 0, m = 0;
            Vec<2> apart = Vec<2>::Zero();
            std::size_t i = 0;
            for (const auto& p : points) {
                kinetic += 0.5 * p.m * p.v.squaredNorm();
                apart += (2 * i++ < points.size() ? p.m : -p.m) * p.v;
                m += p.m;
            }
            rebound = least < least_before ? kinetic : std::max(rebound, kinetic);
            centres = apart.squaredNorm() / (2 * m);
        }
        std::vector<std::pair<std::string, double>> facts(double t_end) const {
            auto all = TwoDisks<false>::Observer::facts(t_end);
            all.insert(all.begin() + 4, {{"rebound: largest kinetic energy after / at the start", rebound / first},
                                         {"the same of the centres at the end", centres / first}});
            return all;
        }
        std::vector<NamedError> errors(double t_end) const {
            auto all = TwoDisks<false>::Observer::errors(t_end);
            all.push_back({"rebound", std::abs(rebound / first - 1)});
            return all;
        }
    };

private:
    Outline outline(const Vec<2>& centre, double edge) const {
        return circle(centre, radius, std::max(8, static_cast<int>(std::lround(2 * std::numbers::pi * radius / edge))));
    }
    /// Triangles of about this area: those of a refined mesh are nearly equilateral, their edges between `edge` and half of it.
    Triangles triangles_about(const Vec<2>& centre, double area) const {
        const double edge = 2 * std::sqrt(area / std::numbers::sqrt3);
        return triangles(outline(centre, edge), 1.4 * edge);
    }
    /// Squares of the grid's own places.
    PolygonCells boxes(const Vec<2>& centre, double size) const {
        const int n = static_cast<int>(std::ceil(radius / size)) + 1;
        const Vec<2> corner = centre - Vec<2>::Constant(n * size);
        const PolygonCells all = polygon_cells(quadrilaterals_of(Box{corner, centre + Vec<2>::Constant(n * size)}, {2 * n, 2 * n}));
        PolygonCells inside{all.points, {}};
        for (std::size_t i = 0; i < all.corners.size(); ++i)
            if ((cell_moments(all.points, all.corners[i], i).centroid - centre).norm() <= radius) inside.corners.push_back(all.corners[i]);
        if (inside.corners.empty()) throw BadInput("--cells, --ppc, --radius: no box lies inside the disks");
        return inside;
    }
    /// The disk, and after it what a point mirrors it to.
    PolygonCells with_mirror(const PolygonCells& disk, double h) const {
        PolygonCells both = disk;
        const int shift = static_cast<int>(disk.points.size());
        for (const Vec<2>& x : disk.points) both.points.push_back(Vec<2>::Constant(1 + 2 * offset * h) - x);
        for (std::vector<int> cell : disk.corners) {
            for (int& c : cell) c += shift;
            both.corners.push_back(cell);
        }
        return both;
    }
};

}  // namespace mpm
