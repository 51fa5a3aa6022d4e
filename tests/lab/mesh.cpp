// Triangle meshes of polygons, and the particles of meshes: their mass is area times density to rounding.
#include "lab/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "chapters/explicit/point.hpp"
#include "tests/lab/tessellation.hpp"

namespace mpm::test {
namespace {

const Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon frame({{0, 0}, {2, 0}, {2, 1.5}, {0, 1}}, {circle(Vec<2>(0.6, 0.5), 0.3, 30), {{1.2, 0.4}, {1.2, 0.8}, {1.7, 0.6}}});

template <class Points> double mass(const Points& points) {
    double sum = 0;
    for (const auto& p : points) sum += p.m;
    return sum;
}
template <class Points> double moment(const Points& points, const std::function<double(const Vec<2>&)>& f) {
    double sum = 0;
    for (const auto& p : points) sum += p.V0 * f(p.x);
    return sum;
}

TEST(Refine, KeepsTheAreaOfThePolygon) {
    for (const double size : {0.5, 0.1, 0.02}) {
        const Triangles mesh = refine(frame, size);
        EXPECT_NEAR(mesh_area(mesh), frame.area(), 1e-12 * frame.area()) << "points on slanted edges are rounded";
        EXPECT_NEAR(mass(particles_at_centroids<Point<2>>(mesh, 7)), 7 * frame.area(), 1e-12 * 7 * frame.area());
        EXPECT_NEAR(mass(particles_at_gauss_points<Point<2>>(mesh, 7)), 7 * frame.area(), 1e-12 * 7 * frame.area());
    }
}
TEST(Refine, KeepsSizeAndAngle) {
    for (const double angle : {0.0, 10.0, 20.7}) {
        const Triangles mesh = refine(frame, 0.07, angle);
        EXPECT_GE(smallest_angle(mesh), angle);
        for (const auto& c : mesh.corners)
            for (const std::size_t i : {0u, 1u, 2u})
                EXPECT_LE((mesh.points[static_cast<std::size_t>(c[i])] - mesh.points[static_cast<std::size_t>(c[(i + 1) % 3])]).norm(),
                          0.07 * (1 + 1e-12));
    }
}
TEST(Refine, JoinsTrianglesAlongWholeEdges) {
    const Triangles mesh = refine(frame, 0.1);
    std::map<std::pair<int, int>, int> uses;
    double boundary = 0;
    for (const auto& c : mesh.corners)
        for (const std::size_t i : {0u, 1u, 2u}) ++uses[std::minmax(c[i], c[(i + 1) % 3])];
    for (const auto& [edge, n] : uses) {
        EXPECT_LE(n, 2);
        if (n == 1)
            boundary += (mesh.points[static_cast<std::size_t>(edge.first)] - mesh.points[static_cast<std::size_t>(edge.second)]).norm();
    }
    EXPECT_NEAR(boundary, frame.perimeter(), 1e-12 * frame.perimeter()) << "the boundary is that of the polygon";
}
TEST(Refine, PutsNoTriangleIntoHoles) {
    for (const auto& p : particles_at_centroids<Point<2>>(refine(frame, 0.05), 1)) EXPECT_TRUE(frame.inside(p.x)) << p.x.transpose();
}
TEST(Refine, TakesSharpCornersAsTheyAre) {
    const Polygon needle({{0, 0}, {1, 0}, {1, 0.02}});
    const Triangles mesh = refine(needle, 0.1);
    EXPECT_NEAR(mesh_area(mesh), needle.area(), 1e-12 * needle.area());
    EXPECT_LT(smallest_angle(mesh), 1.2);
}
TEST(Refine, TakesAHundredThousandCorners) {
    const Polygon polygon(circle(Vec<2>(3, -2), 5, 100000));
    const Triangles mesh = refine(polygon, 2, 0);
    EXPECT_GE(mesh.corners.size(), 100000u - 2);
    EXPECT_NEAR(mesh_area(mesh), polygon.area(), 1e-12 * polygon.area());
}

TEST(Triangulate, JoinsThePolygonsCorners) {
    const Triangles mesh = triangulate(frame);
    EXPECT_EQ(mesh.points.size(), 37u);
    EXPECT_EQ(mesh.corners.size(), 39u) << "n + 2 (holes - 1)";
    expect_tessellation(mesh, frame);
}

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const BadInput& bad) {
        return bad.what();
    }
    return "none";
}
TEST(Refine, RefusesImpossibleSizesAndAngles) {
    const Polygon polygon(square);
    const double nan = std::nan("");
    for (const double size : {0.0, -1.0, nan, Bounds::inf})
        EXPECT_NE(refusal([&] { refine(polygon, size); }).find("mesh: size = "), std::string::npos);
    for (const double angle : {-1.0, 21.0, 60.0, nan})
        EXPECT_NE(refusal([&] { refine(polygon, 1, angle); }).find("allowed 0 ... 20.7 degrees"), std::string::npos);
    EXPECT_EQ(refusal([&] { refine(polygon, 1e-9); }), "mesh: size = 1e-09 needs more than 5000000 triangles");
    EXPECT_EQ(refusal([&] { refine(polygon, 0.2, 20, 51); }), "mesh: size = 0.2 needs more than 51 triangles");
}

const Triangles two{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{0, 1, 2}, {0, 3, 2}}};  // the second clockwise

TEST(ParticlesOfTriangles, IntegrateAsTheirPointsDo) {
    const Triangles mesh = refine(frame, 0.3), fine = refine(frame, 0.01);
    const auto linear = [](const Vec<2>& x) { return 1 + 2 * x[0] - 3 * x[1]; };
    const auto quadratic = [](const Vec<2>& x) { return x[0] * x[0] - 3 * x[0] * x[1] + 2 * x[1] * x[1]; };
    const double exact = moment(particles_at_gauss_points<Point<2>>(fine, 1), quadratic);  // exact on both meshes
    EXPECT_NEAR(moment(particles_at_centroids<Point<2>>(mesh, 1), linear), moment(particles_at_gauss_points<Point<2>>(fine, 1), linear),
                1e-12);
    EXPECT_NEAR(moment(particles_at_gauss_points<Point<2>>(mesh, 1), quadratic), exact, 1e-12);
    EXPECT_GT(std::abs(moment(particles_at_centroids<Point<2>>(mesh, 1), quadratic) - exact), 1e-4) << "no better than stated";
}
TEST(ParticlesOfTriangles, TakeEitherWayRound) {
    const auto points = particles_at_centroids<Point<2>>(two, 3);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_DOUBLE_EQ(points[1].V0, 1);
    EXPECT_DOUBLE_EQ(points[1].m, 3);
    EXPECT_NEAR((points[1].x - Vec<2>(2.0 / 3, 2.0 / 3)).norm(), 0, 1e-15);
}

/// Hexagons cut by a square: the cells of a honeycomb, made of corner fans.
PolygonCells honeycomb() {
    PolygonCells cells;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            const Vec<2> centre(std::sqrt(3.0) * (i + 0.5 * (j % 2)), 1.5 * j);
            auto& cell = cells.corners.emplace_back();
            for (int k = 0; k < 6; ++k) {
                const double angle = std::numbers::pi * (2 * k + 1) / 6;
                cell.push_back(static_cast<int>(cells.points.size()));
                cells.points.push_back(centre + Vec<2>(std::cos(angle), std::sin(angle)));
            }
        }
    return cells;
}
TEST(ParticlesOfPolygons, HaveTheMassOfTheCells) {
    const PolygonCells cells = honeycomb();
    const double area = 400 * 1.5 * std::sqrt(3.0);
    const auto points = particles_at_centroids<Point<2>>(cells, 2);
    EXPECT_NEAR(mesh_area(cells), area, 1e-12 * area);
    EXPECT_NEAR(mass(points), 2 * area, 1e-12 * 2 * area);
    EXPECT_NEAR((points[21].x - Vec<2>(1.5 * std::sqrt(3.0), 1.5)).norm(), 0, 1e-14) << "cell (1, 1)";
}
TEST(ParticlesOfPolygons, StandAtTheCentroidOfAnLShape) {
    const PolygonCells cells{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {{5, 4, 3, 2, 1, 0}}};
    const auto points = particles_at_centroids<Point<2>>(cells, 1);
    EXPECT_DOUBLE_EQ(points[0].V0, 3);
    EXPECT_NEAR((points[0].x - Vec<2>(5.0 / 6, 5.0 / 6)).norm(), 0, 1e-15);
}

TEST(Meshes, AreRefusedWithTheirBadCell) {
    const auto said = [](Triangles mesh) { return refusal([&] { particles_at_centroids<Point<2>>(mesh, 1); }); };
    const std::vector<Vec<2>> points{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {std::nan(""), 0}};
    EXPECT_EQ(said({points, {}}), "mesh: it has no cells");
    EXPECT_EQ(said({{}, {{0, 1, 2}}}), "mesh: cell 0 has the corner 0, but the mesh has 0 points");
    EXPECT_EQ(said({points, {{0, 1, 2}, {0, 1, 5}}}), "mesh: cell 1 has the corner 5, but the mesh has 5 points");
    EXPECT_EQ(said({points, {{0, -1, 2}}}), "mesh: cell 0 has the corner -1, but the mesh has 5 points");
    EXPECT_EQ(said({points, {{0, 1, 4}}}), "mesh: cell 0 has the corner 4, which is no number");
    EXPECT_EQ(said({points, {{0, 1, 3}}}), "mesh: cell 0 encloses no area");
    EXPECT_EQ(said({points, {{0, 1, 1}}}), "mesh: cell 0 encloses no area");
    EXPECT_EQ(refusal([&] {
                  particles_at_centroids<Point<2>>(PolygonCells{points, {{0, 1}}}, 1);
              }),
              "mesh: cell 0 has 2 corners, at least 3 are needed");
    EXPECT_EQ(refusal([&] { particles_at_gauss_points<Point<2>>({points, {{0, 1, 3}}}, 1); }), "mesh: cell 0 encloses no area");
}

}  // namespace
}  // namespace mpm::test
