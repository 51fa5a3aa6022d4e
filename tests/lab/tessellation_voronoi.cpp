// Voronoi cells clipped to polygons: no gaps, whole edges shared, and the awkward meetings of cells and outlines.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "lab/options.hpp"
#include "lab/structured.hpp"
#include "lab/voronoi.hpp"
#include "tests/lab/tessellation.hpp"

namespace mpm::test {
namespace {

using Points = std::vector<Vec<2>>;

const Outline unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon square(unit_square), ell({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}),
    slender({{0, 0}, {100, 3}, {100, 3.01}, {0, 0.01}}), ring(circle({0, 0}, 1, 60), {circle({0, 0}, 0.5, 40)}),
    two_holes({{0, 0}, {2, 0}, {2, 1.5}, {0, 1}}, {circle({0.6, 0.5}, 0.3, 30), {{1.2, 0.4}, {1.2, 0.8}, {1.7, 0.6}}}),
    star({{0, 0}, {0.45, 0.4}, {0.5, 0}, {0.55, 0.4}, {1, 0}, {0.6, 0.5}, {1, 1}, {0.5, 0.6}, {0, 1}, {0.4, 0.5}});

/// n x n places in the middles of the unit square's cells.
Points lattice(int n) {
    Points all;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) all.emplace_back((i + 0.5) / n, (j + 0.5) / n);
    return all;
}
Points random_points(std::size_t n, std::uint64_t seed) {
    std::mt19937_64 bits(seed);
    Points all(n);
    for (Vec<2>& x : all)
        for (const int d : {0, 1}) x[d] = std::ldexp(static_cast<double>(bits() >> 11), -53);
    return all;
}
void expect_cells(const PolygonCells& cells, const Polygon& domain) {
    expect_tessellation(cells, domain);
    expect_few_corners(cells);
}

class CentroidalVoronoi : public testing::TestWithParam<std::pair<const char*, const Polygon*>> {};
TEST_P(CentroidalVoronoi, FillsThePolygon) {
    const Polygon& domain = *GetParam().second;
    for (const int n : {1, 2, 3, 10, 60, 700})
        for (const int iterations : {0, 3, 50}) {
            SCOPED_TRACE(std::to_string(n) + " cells, iterations: " + std::to_string(iterations));
            const auto made = centroidal_voronoi(domain, n, {iterations});
            EXPECT_LE(made.iterations, iterations) << "fewer where nothing moves any more";
            EXPECT_GE(made.cells.corners.size(), static_cast<std::size_t>(n));
            expect_cells(made.cells, domain);
        }
}
INSTANTIATE_TEST_SUITE_P(Polygons, CentroidalVoronoi,
                         testing::Values(std::pair("square", &square), std::pair("ell", &ell), std::pair("slender", &slender),
                                         std::pair("ring", &ring), std::pair("two_holes", &two_holes), std::pair("star", &star)),
                         [](const auto& tested) { return std::string(tested.param.first); });

TEST(CentroidalVoronoiCells, BecomeAlike) {
    const auto spread = [](int iterations) {
        const PolygonCells cells = centroidal_voronoi(two_holes, 1000, {iterations}).cells;
        double low = 1, high = 0;
        for (std::size_t i = 0; i < cells.corners.size(); ++i) {
            const double area = cell_moments(cells.points, cells.corners[i], i).area;
            low = std::min(low, area), high = std::max(high, area);
        }
        return high / low;
    };
    EXPECT_GT(spread(0), 10);
    EXPECT_LT(spread(100), 3);
}
TEST(CentroidalVoronoiCells, EndWhereSeedsRest) {
    const auto made = centroidal_voronoi(square, 4, {1000, 1e-9});
    EXPECT_LT(made.iterations, 1000);
    EXPECT_LE(made.moved, 1e-9);
    expect_cells(made.cells, square);
    for (std::size_t i = 0; i < made.cells.corners.size(); ++i) {  // four quarters are the only place of rest this start leads to
        const CellMoments cell = cell_moments(made.cells.points, made.cells.corners[i], i);
        EXPECT_NEAR(cell.area, 0.25, 1e-6);
        EXPECT_NEAR((cell.centroid - Vec<2>(0.5, 0.5)).cwiseAbs().sum(), 0.5, 1e-6);
    }
}
TEST(CentroidalVoronoiCells, AreTheSameForOneSeedOnly) {
    const auto cells = [](std::uint64_t seed) { return centroidal_voronoi(ell, 50, {5, 0, seed}).cells; };
    EXPECT_EQ(cells(3).points, cells(3).points);
    EXPECT_EQ(cells(3).corners, cells(3).corners);
    EXPECT_NE(cells(3).points, cells(4).points);
}
TEST(CentroidalVoronoiCells, AreSmallWhereTheOutlineIsFine) {
    const Polygon disk(circle({3, -2}, 5, 2000));
    for (const int n : {1, 3, 100}) expect_cells(centroidal_voronoi(disk, n, {5}).cells, disk);
}
TEST(CentroidalVoronoiCells, DependOnNoUnitAndLittleOnThePlace) {
    for (const double unit : {1e-9, 1.0, 1e9})
        for (const double away : {0.0, 1e4}) {
            Outline outline = ell.outer();
            for (Vec<2>& x : outline) x = unit * (x + Vec<2>(away, -away));
            const Polygon domain(outline);
            const auto cells = centroidal_voronoi(domain, 200).cells;
            expect_few_corners(cells);
            EXPECT_EQ(cells.corners.size(), 200u);
            // Points on the outline are rounded to the digits of their coordinates.
            EXPECT_NEAR(mesh_area(cells), domain.area(), (1e-12 + 1e-15 * away) * domain.area());
        }
}

TEST(VoronoiCells, AreWhatIsNearestToASeed) {
    const Points seeds = random_points(40, 1);
    const PolygonCells mesh = voronoi(square, seeds);
    expect_cells(mesh, square);
    ASSERT_EQ(mesh.corners.size(), 40u);
    std::vector<Polygon> cells;
    for (const auto& corners : mesh.corners) cells.emplace_back(outline_of(mesh.points, corners));
    const auto distance = [](const Vec<2>& a, const Vec<2>& b) { return (a - b).norm(); };
    for (const Vec<2>& x : random_points(2000, 2)) {
        Points near = seeds;
        std::sort(near.begin(), near.end(), [&](const Vec<2>& a, const Vec<2>& b) { return distance(a, x) < distance(b, x); });
        // Tiny edges became points: a boundary between cells may lie 2 % of the spacing beside the bisector.
        if (distance(near[1], x) - distance(near[0], x) < 0.04 / std::sqrt(40)) continue;
        const auto holds = [&](const Polygon& cell) { return cell.inside(x); };
        const auto cell = std::find_if(cells.begin(), cells.end(), holds);
        ASSERT_NE(cell, cells.end());
        EXPECT_TRUE(cell->inside(near[0]));
    }
}
TEST(VoronoiCells, OfALatticeAreSquares) {
    const PolygonCells mesh = voronoi(square, lattice(8));
    EXPECT_EQ(mesh.points.size(), 81u) << "four cells meet in one point";
    ASSERT_EQ(mesh.corners.size(), 64u);
    expect_cells(mesh, square);
}
// All edges of the notch lie along edges of cells, its corners are corners of cells.
TEST(VoronoiCells, TakeOutlinesAlongTheirEdges) {
    const Polygon notched({{0, 0}, {1, 0}, {1, 1}, {0.75, 1}, {0.75, 0.25}, {0.25, 0.25}, {0.25, 1}, {0, 1}});
    const Polygon frame(unit_square, {{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}}});
    for (const int n : {4, 8, 16})
        for (const Polygon& domain : {notched, frame}) {
            const PolygonCells mesh = voronoi(domain, lattice(n));
            expect_cells(mesh, domain);
            EXPECT_EQ(mesh.corners.size(), static_cast<std::size_t>(std::lround(n * n * domain.area())));
            for (const auto& corners : mesh.corners) EXPECT_EQ(corners.size(), 4u);
        }
}
// Edges of the notch pass through seeds or lie a little beside edges of cells.
TEST(VoronoiCells, TakeOutlinesBesideTheirEdges) {
    for (const double shift : {0.125, 1e-3, 1e-6, 1e-9, 1e-12, -1e-12, -1e-9, -1e-6, -1e-3}) {
        const double a = 0.25 + shift;
        const Polygon notched({{0, 0}, {1, 0}, {1, 1}, {0.75, 1}, {0.75, 0.25}, {a, 0.25}, {a, 1}, {0, 1}});
        expect_cells(voronoi(notched, lattice(4)), notched);
    }
}
TEST(VoronoiCells, TakeOutlinesThroughTheirCorners) {
    const Polygon diamond({{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}});
    const Polygon hollow(unit_square, {{{0.5, 0.25}, {0.75, 0.5}, {0.5, 0.75}, {0.25, 0.5}}});
    for (const int n : {2, 4, 8})
        for (const Polygon& domain : {diamond, hollow}) expect_cells(voronoi(domain, lattice(n)), domain);
}
TEST(VoronoiCells, GoAroundAHoleInTwoParts) {
    for (const int n : {1, 2, 5})  // 5: no other cell of the middle's neighbours touches an outline
        for (const int corners : {3, 4, 7}) {
            const Vec<2> middle = lattice(n)[static_cast<std::size_t>(n * n / 2)];
            const Polygon domain(unit_square, {circle(middle, 0.2 / n, corners)});
            const PolygonCells mesh = voronoi(domain, lattice(n));
            expect_cells(mesh, domain);
            EXPECT_EQ(mesh.corners.size(), static_cast<std::size_t>(n * n + 1));
        }
}
TEST(VoronoiCells, GoAroundHolesBesideEachOther) {
    const Polygon beside(unit_square, {circle({0.25, 0.5}, 0.1, 8), circle({0.5, 0.5}, 0.1, 8), circle({0.75, 0.5}, 0.1, 8)});
    const Polygon above(unit_square, {circle({0.5, 0.25}, 0.1, 8), circle({0.5, 0.5}, 0.1, 8), circle({0.52, 0.75}, 0.1, 8)});
    const Polygon within(unit_square,
                         {{{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.75, 0.8}, {0.75, 0.25}, {0.2, 0.25}}, circle({0.5, 0.5}, 0.1, 8)});
    const Polygon squares(unit_square,
                          {{{0.2, 0.4}, {0.4, 0.4}, {0.4, 0.6}, {0.2, 0.6}}, {{0.6, 0.4}, {0.8, 0.4}, {0.8, 0.6}, {0.6, 0.6}}});
    for (const Polygon& domain : {beside, above, within, squares})
        for (const int n : {1, 2, 3}) expect_cells(voronoi(domain, lattice(n)), domain);
}
// One meeting with an edge does not connect a hole: its cell still goes all around.
TEST(VoronoiCells, GoAroundAHoleThatTouchesTheirEdge) {
    for (const Outline& hole : {Outline{{0.5, 0.2}, {0.4, 0.25}, {0.4, 0.15}}, Outline{{0.2, 0.5}, {0.15, 0.4}, {0.25, 0.4}},
                                Outline{{0.5, 0.3}, {0.4, 0.3}, {0.4, 0.2}, {0.5, 0.2}}, Outline{{0.5, 0.5}, {0.4, 0.45}, {0.45, 0.4}}}) {
        const Polygon domain(unit_square, {hole});
        expect_cells(voronoi(domain, lattice(2)), domain);
    }
}
// The upper cell of a fork has a part in each prong.
TEST(VoronoiCells, AreDividedByTheOutline) {
    const auto cells = [](double prong) {
        const Polygon fork({{0, 0}, {1, 0}, {1, 1}, {1 - prong, 1}, {1 - prong, 0.2}, {0.4, 0.2}, {0.4, 1}, {0, 1}});
        const PolygonCells mesh = voronoi(fork, {{0.5, 0.1}, {0.5, 0.9}});
        expect_cells(mesh, fork);
        return mesh.corners.size();
    };
    EXPECT_EQ(cells(0.4), 3u);
    EXPECT_EQ(cells(0.05), 2u) << "a thin prong belongs to the lower cell";
}

// A gap between holes that is narrower than what counts as one place, 1e-8 for cells of spacing 0.1.
TEST(VoronoiCells, AreCutByANarrowGap) {
    const double x = 0.5 + 1e-10;
    const Polygon domain(unit_square, {{{0.2, 0.3}, {0.5, 0.3}, {0.5, 0.7}, {0.2, 0.7}}, {{x, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {x, 0.8}}});
    expect_cells(voronoi(domain, lattice(10)), domain);
    expect_cells(centroidal_voronoi(domain, 100).cells, domain);
}

// Jagged polygons with up to three holes, half of them with corners on a lattice of 1/16 as the seeds are.
TEST(VoronoiCells, FillJaggedPolygons) {
    std::mt19937_64 bits(7);
    const auto dice = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -53); };
    const auto whole = [&](int n) { return static_cast<int>(n * dice()); };
    const auto on_lattice = [](const Vec<2>& x) -> Vec<2> { return (16 * x).array().round().matrix() / 16; };
    int tried = 0;
    while (tried < 2000) {
        const int n = 3 + whole(20), cells = 1 + whole(12);
        const bool aligned = dice() < 0.5;
        Outline outline;
        for (int k = 0; k < n; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.3 * dice()) / n, r = 0.2 + 0.3 * dice();
            const Vec<2> x = Vec<2>(0.5, 0.5) + r * Vec<2>(std::cos(angle), std::sin(angle));
            outline.push_back(aligned ? on_lattice(x) : x);
        }
        std::vector<Outline> holes;
        for (int k = whole(4); k > 0; --k) {
            const Vec<2> c(0.4 + 0.2 * dice(), 0.4 + 0.2 * dice());
            holes.push_back(circle(aligned ? on_lattice(c) : c, 0.005 + 0.04 * dice(), 3 + whole(8)));
        }
        Points seeds = aligned ? lattice(cells) : random_points(static_cast<std::size_t>(cells * cells), bits());
        try {
            const Polygon domain(outline, holes);
            const Bounds b = domain.bounds();
            std::erase_if(seeds, [&](const Vec<2>& x) { return !Box{b.low, b.high}.inside(x); });
            if (seeds.empty()) continue;
            ++tried;
            SCOPED_TRACE(tried);
            PolygonCells mesh;
            ASSERT_NO_THROW(mesh = voronoi(domain, seeds));
            expect_cells(mesh, domain);
        } catch (const BadInput&) {  // outlines that cross are no polygon
        }
    }
}

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const BadInput& bad) {
        return bad.what();
    }
    return "none";
}
TEST(VoronoiCells, AreRefusedInOneLine) {
    for (const long n : {0L, -3L, CellCounts{552761, 552761}.all()})
        EXPECT_EQ(refusal([&] { centroidal_voronoi(square, n); }), "voronoi: " + std::to_string(n) + " cells: allowed 1 ... 5000000");
    EXPECT_EQ(refusal([] { centroidal_voronoi(square, 2000000000); }), "voronoi: 2000000000 cells: allowed 1 ... 5000000");
    EXPECT_EQ(refusal([] { centroidal_voronoi(square, 2, {-1}); }), "voronoi: -1 iterations: allowed >= 0");
    EXPECT_EQ(refusal([] { centroidal_voronoi(square, 2, {1, std::nan("")}); }), "voronoi: tolerance = nan: allowed >= 0");
    const Polygon far({{1e8, 0}, {1e8 + 1, 0}, {1e8, 1}});
    EXPECT_EQ(
        refusal([&] { centroidal_voronoi(far, 5000); }),
        "voronoi: 5000 cells are too small for the digits of coordinates near 100000001: spacing 0.01, shortest edge of the polygon 1");
    EXPECT_EQ(refusal([] { voronoi(square, {}); }), "voronoi: 0 cells: allowed 1 ... 5000000");
    EXPECT_EQ(refusal([] { voronoi(square, {{0.5, 0.5}, {0.5, 2}}); }), "voronoi: the seed (0.5, 2) is out of the polygon's bounds");
    EXPECT_EQ(refusal([] { voronoi(square, {{0.5, 0.5}, {0.25, 0.5}, {0.5, 0.5}}); }), "voronoi: two seeds at (0.5, 0.5)");
}

}  // namespace
}  // namespace mpm::test
