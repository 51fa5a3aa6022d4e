// What the monitor sees on particles and cells.
#include "lab/monitor.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "chapters/explicit/flip.hpp"
#include "chapters/material/linear_elastic.hpp"
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/coverage.hpp"

namespace mpm {
namespace {

template <int D> using Bodies = std::vector<Body<D, Point<D>, Node<D>, LinearElastic, Tensor<D, Hat>, Flip>>;

/// Cells 2 ... 7 of 10 (in each direction), one particle in the middle of each.
template <int D> Bodies<D> block() {
    std::array<int, D> cells;
    cells.fill(10);
    const Lattice<D> lattice(Vec<D>::Zero(), Vec<D>::Ones(), cells);
    std::vector<Point<D>> points;
    for (int j = 2; j < (D == 2 ? 8 : 3); ++j)
        for (int i = 2; i < 8; ++i) {
            Point<D> p;
            p.x[0] = i + 0.5;
            if constexpr (D == 2) p.x[1] = j + 0.5;
            p.m = p.V = p.V0 = 1;
            points.push_back(p);
        }
    Bodies<D> bodies;
    bodies.push_back({{points, Grid<D, Node<D>>(lattice), LinearElastic{0, 1, 1}}, {lattice, {}}, {}});
    return bodies;
}

TEST(CheckParticles, NamesTheOneTurnedInsideOut) {
    auto bodies = block<1>();
    EXPECT_FALSE(check_particles(bodies[0]));
    bodies[0].points[3].V = -0.1;
    const Trouble t = check_particles(bodies[0]);
    EXPECT_EQ(t.cause, "inverted-particle");
    EXPECT_NE(t.reason.find("particle 3 at x = 5.5"), std::string::npos);
}

TEST(CheckParticles, NamesTheOneThatIsNoNumber) {
    auto bodies = block<2>();
    bodies[0].points[5].V = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(check_particles(bodies[0]).cause, "not-finite");
}

TEST(CoverageTest, AGapInABarIsNumericalFracture) {
    auto bodies = block<1>();
    Coverage<1> coverage(bodies[0], 2);
    EXPECT_FALSE(coverage.check(bodies[0]));
    for (std::size_t i = 3; i < 6; ++i) bodies[0].points[i].x[0] += 1;
    const Trouble t = coverage.check(bodies[0]);
    EXPECT_EQ(t.cause, "numerical-fracture");
    EXPECT_NE(t.reason.find("x = 5.5"), std::string::npos) << t.reason;
}

TEST(CoverageTest, SmoothFunctionsReachAcrossOneCell) {
    auto bodies = block<1>();
    Coverage<1> coverage(bodies[0], 4);  // cubic: the four nodes of a point, three cells
    for (std::size_t i = 3; i < 6; ++i) bodies[0].points[i].x[0] += 1;
    EXPECT_FALSE(coverage.check(bodies[0]));
}

TEST(CoverageTest, AStretchedBodyHasNoGap) {
    auto bodies = block<1>();
    Coverage<1> coverage(bodies[0], 2);
    for (auto& p : bodies[0].points) {
        p.x[0] = 0.2 + (p.x[0] - 2) * 1.6;  // every third cell is without a particle, but each particle is 1.6 cells long
        p.F(0, 0) = 1.6;
    }
    EXPECT_FALSE(coverage.check(bodies[0]));
}

TEST(CoverageTest, ABodyThatFliesAcrossCellsHasNoGap) {
    auto bodies = block<2>();
    Coverage<2> coverage(bodies[0], 2);
    for (int k = 0; k < 40; ++k) {
        for (auto& p : bodies[0].points) p.x += Vec<2>(0.037, -0.021);
        EXPECT_FALSE(coverage.check(bodies[0])) << k;
    }
}

TEST(CoverageTest, AHoleInASquareIsNumericalFracture) {
    auto bodies = block<2>();
    Coverage<2> coverage(bodies[0], 2);
    bodies[0].points.erase(bodies[0].points.begin() + 14);
    EXPECT_EQ(coverage.check(bodies[0]).cause, "numerical-fracture");
}

TEST(CoverageTest, AHoleFromTheStartIsNot) {
    auto bodies = block<2>();
    bodies[0].points.erase(bodies[0].points.begin() + 14);
    Coverage<2> coverage(bodies[0], 2);
    EXPECT_FALSE(coverage.check(bodies[0]));
}

TEST(MasslessNode, IsNamedInsideABodyAndNotAtItsEnd) {
    auto bodies = block<1>();  // particles of mass 1 in cells 2 ... 7
    for (int I = 2; I <= 8; ++I) bodies[0].grid[I].m = 1;
    bodies[0].grid[2].m = 1e-12;  // the end
    EXPECT_FALSE((massless_node<1>(bodies[0], NodeWatch::tiny)));
    bodies[0].grid[5].m = 1e-12;
    const Trouble t = massless_node<1>(bodies[0], NodeWatch::tiny);
    EXPECT_EQ(t.cause, "massless-node");
    EXPECT_NE(t.reason.find("node 5 at x = 5"), std::string::npos) << t.reason;
}
TEST(NodeWatchTest, CountsTinyAndCutNodes) {
    auto bodies = block<1>();
    bodies[0].grid[2].m = 1e-12;
    bodies[0].grid[3].m = 0.5;
    NodeWatch watch;
    watch.look(bodies[0], 1e-9);
    watch.look(bodies[0], 0);
    EXPECT_EQ(watch.tiny_nodes, 2);
    EXPECT_EQ(watch.cut_nodes, 1);
    EXPECT_EQ(watch.smallest, 1e-12);
}

}  // namespace
}  // namespace mpm
