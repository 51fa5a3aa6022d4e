// Bodies that lie in each other are found wherever they are; bodies that touch are not.
#include "lab/overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace mpm::test {
namespace {

struct Particle {
    static constexpr int D = 2;
    Vec<2> x;
    double V = 0;
};
struct Node {
    void reset() {}
};
struct NoLaw {};
using Block = Matter<2, Particle, Node, NoLaw>;

/// A block of n x n particles, two per cell and axis of size 1, from a corner on.
Block block(double x, double y, int n) {
    Block b{{}, Grid<2, Node>(Lattice<2>(Vec<2>::Zero(), Vec<2>::Ones(), {4, 4})), {}};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) b.points.push_back({Vec<2>(x + 0.25 + 0.5 * i, y + 0.25 + 0.5 * j), 0.25});
    return b;
}
Trouble overlap(std::vector<Block> blocks) {
    std::vector<Block*> bodies;
    for (Block& b : blocks) bodies.push_back(&b);
    return check_overlap<2>(bodies);
}

TEST(Overlap, NamesBothBodiesAndHowManyCellsTheyShare) {
    const Trouble trouble = overlap({block(-9, -9, 2), block(0, 0, 4), block(1, 0, 4)});
    EXPECT_EQ(trouble.cause, "bodies-passed-through");
    EXPECT_NE(trouble.reason.find("bodies 1 and 2"), std::string::npos) << trouble.reason;
    EXPECT_NE(trouble.reason.find("2 cells"), std::string::npos) << trouble.reason;
}
TEST(Overlap, IsFoundOutsideTheGridToo) { EXPECT_TRUE(overlap({block(-7, 20, 4), block(-6.5, 20.5, 4)})); }

// A particle on a line of the lattice, as rounding puts it, stays in the boxes that the outermost particles span.
TEST(Overlap, CountsEveryParticleInABox) {
    for (int n = 3; n < 60; ++n) {
        const double h = 1.0 / n;
        Block b{{}, Grid<2, Node>(Lattice<2>(Vec<2>::Constant(-2 * h), Vec<2>::Constant(h), {4, 4})), {}};
        for (int i = -n; i <= n; ++i) b.points.push_back({Vec<2>(i * h, i / (n + 0.0)), 0.25});
        const CellBoxes<2> boxes(std::vector<Block*>{&b});
        ASSERT_TRUE(boxes.usable);
        for (const Particle& p : b.points) ASSERT_LT(boxes.of(p.x), boxes.count()) << "n = " << n << ", x = " << p.x.transpose();
    }
}

// Whatever the place of the touching faces in their cells, what both fill sums to the cell.
TEST(Overlap, IsNotSeenWhereBodiesTouch) {
    for (int i = 0; i <= 20; ++i) EXPECT_FALSE(overlap({block(0.05 * i, 0, 4), block(0.05 * i + 2, 0.3, 4)})) << i;
}
// Particles are counted by their centres: along an inclined face two triangles of half a cell may hold six of nine particles each.
TEST(Overlap, IsNotSeenAlongInclinedFaces) {
    const double c = std::sqrt(0.5);
    for (int ppc = 2; ppc <= 5; ++ppc)
        for (int shift = 0; shift < 40; ++shift) {
            std::vector<Block> halves{block(0, 0, 0), block(0, 0, 0)};
            for (int j = -4 * ppc; j < 4 * ppc; ++j)
                for (int i = -4 * ppc; i < 4 * ppc; ++i) {
                    const double along = (i + 0.5 + 0.025 * shift) / ppc, above = (j + 0.5) / ppc;
                    halves[j < 0].points.push_back({Vec<2>(c * (along - above), c * (along + above)), 1.0 / (ppc * ppc)});
                }
            EXPECT_FALSE(overlap(halves)) << ppc << " " << shift;
        }
}
// A layer of one and a half cells has three particles of four of some cell in each body, wherever the cells' edges are.
TEST(Overlap, IsSeenBeforeItIsTwoCellsDeep) {
    for (int i = 0; i <= 20; ++i) EXPECT_TRUE(overlap({block(0.05 * i, 0, 4), block(0.05 * i + 0.5, 0, 4)})) << i;
}
TEST(Overlap, LeavesWhatIsNoNumberToOtherChecks) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
        std::vector<Block> blocks{block(0, 0, 4), block(0, 0, 4)};
        blocks[1].points[3].x[1] = bad;
        EXPECT_FALSE(overlap(blocks));
    }
}
TEST(Overlap, OfEmptyBodiesIsNone) { EXPECT_FALSE(overlap({block(0, 0, 0), block(0, 0, 0)})); }

}  // namespace
}  // namespace mpm::test
