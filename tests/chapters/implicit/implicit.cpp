// Whole steps of implicit MPM.
#include "chapters/implicit/implicit.hpp"

#include <gtest/gtest.h>

#include "tests/chapters/implicit/block.hpp"

namespace mpm {
namespace {

ImplicitSettings settings_of(Carry carry) {
    ImplicitSettings s;
    s.carry = carry;
    if (by_midpoint(carry)) s.newmark = Newmark::midpoint();
    s.automatic = carry == Carry::conserving;
    s.soft = {1e-4, 1e-8};
    return s;
}

TEST(ImplicitMpm, NewtonConvergesQuadratically) {
    Block block;
    ImplicitSettings s = settings_of(Carry::particle);
    s.newton.tolerance = 1e-15;
    s.newton.iterations = 8;
    s.cuts = 0;
    BlockMethod method(s, block.grid, block.body, block.scene);
    method.keep_history(true);
    method.step(0, 0.3);
    std::vector<double> r;
    for (const NewtonRecord& record : method.history()[0].newton.history)
        if (record.residual > 1e-12 * record.terms) r.push_back(record.residual / record.terms);  // above rounding
    ASSERT_GE(r.size(), 4u);
    const std::size_t n = r.size();
    // The exponent of r_(k+1) = C r_k^q from the last three residuals: 2, less what the constant still changes.
    EXPECT_GT(std::log(r[n - 1] / r[n - 2]) / std::log(r[n - 2] / r[n - 3]), 1.7);
}

/// Without held nodes and body force.
TEST(ImplicitMpm, MomentumIsKept) {
    for (const Carry carry : {Carry::particle, Carry::midpoint, Carry::conserving}) {
        Block block;
        const Vec<2> before = block.momentum();
        BlockMethod method(settings_of(carry), block.grid, block.body, block.scene);
        for (int n = 0; n < 5; ++n) method.step(0.05 * n, 0.05);
        EXPECT_FALSE(method.trouble());
        EXPECT_LT((block.momentum() - before).norm(), 1e-13 * before.norm() * 100);  // sums of 64 particles, 5 steps
    }
}
TEST(ImplicitMpm, ImpulseOfAHeldFloorAccountsForTheMomentum) {
    Block block;
    block.scene.held_floor = true;
    block.scene.b = {0, -1};
    const Vec<2> before = block.momentum();
    ImplicitSettings s = settings_of(Carry::particle);
    s.newton.tolerance = 1e-13;
    BlockMethod method(s, block.grid, block.body, block.scene);
    Vec<2> impulse = Vec<2>::Zero();
    for (int n = 0; n < 5; ++n) {
        method.step(0.05 * n, 0.05);
        impulse += Vec<2>(method.supply().impulse[0], method.supply().impulse[1]);
    }
    EXPECT_GT(impulse.norm(), 0.1);
    EXPECT_LT((block.momentum() - before - impulse).norm(), 1e-10);  // Newton's tolerance
}
TEST(ImplicitMpm, ConservingStepsKeepTheEnergyWhereverParticlesGo) {
    Block block;
    ImplicitSettings s = settings_of(Carry::conserving);
    s.soft = {};
    BlockMethod method(s, block.grid, block.body, block.scene);
    const double before = block.energy();
    for (int n = 0; n < 10; ++n) method.step(0.1 * n, 0.1);
    EXPECT_FALSE(method.trouble());
    EXPECT_NEAR(block.energy() / before, 1, 1e-9);  // Newton's tolerance in each step
}
TEST(ImplicitMpm, InactiveNodesSolvedForGiveTheSame) {
    Block left_out, solved;
    ImplicitSettings s = settings_of(Carry::particle);
    BlockMethod one(s, left_out.grid, left_out.body, left_out.scene);
    s.solve_inactive = true;
    BlockMethod other(s, solved.grid, solved.body, solved.scene);
    for (int n = 0; n < 3; ++n) one.step(0.05 * n, 0.05), other.step(0.05 * n, 0.05);
    EXPECT_LT(one.system().unknowns(), other.system().unknowns());
    for (std::size_t i = 0; i < left_out.body.points.size(); ++i)
        EXPECT_LT((left_out.body.points[i].x - solved.body.points[i].x).norm(), 1e-13);  // another order of elimination
}
TEST(ImplicitMpm, BothTangentsGiveTheSameSteps) {
    Block by_hand, automatic;
    ImplicitSettings s = settings_of(Carry::particle);
    BlockMethod one(s, by_hand.grid, by_hand.body, by_hand.scene);
    s.automatic = true;
    BlockMethod other(s, automatic.grid, automatic.body, automatic.scene);
    for (int n = 0; n < 3; ++n) one.step(0.05 * n, 0.05), other.step(0.05 * n, 0.05);
    for (std::size_t i = 0; i < by_hand.body.points.size(); ++i)
        EXPECT_LT((by_hand.body.points[i].v - automatic.body.points[i].v).norm(), 1e-11);
}
TEST(ImplicitMpm, SymbolicFactorisationIsReusedWhileTheActiveSetStands) {
    Block block;
    BlockMethod method(settings_of(Carry::particle), block.grid, block.body, block.scene);
    for (int n = 0; n < 3; ++n) method.step(1e-4 * n, 1e-4);
    EXPECT_EQ(method.system().analyses(), 1);
    EXPECT_GE(method.system().factorisations(), 3);
}
TEST(ImplicitMpm, AnUnsolvableStepIsCutAndThenNamed) {
    Block block;
    for (auto& p : block.body.points) p.v = 300 * (Vec<2>(2, 1) - p.x);  // all into one point within the step
    const auto before = block.body.points[0].x;
    ImplicitSettings s = settings_of(Carry::particle);
    s.newton.iterations = 2;
    s.newton.halvings = 0;
    s.cuts = 3;
    BlockMethod method(s, block.grid, block.body, block.scene);
    method.step(0, 1);
    EXPECT_EQ(method.trouble().cause, "unsolvable-step");
    EXPECT_NE(method.trouble().reason.find("after 3 halvings"), std::string::npos);
    EXPECT_EQ(method.counts().cuts, 3);
    EXPECT_EQ(block.body.points[0].x, before);
}
TEST(ActiveGrid, FlagsCountTheNodesThatEmptyElementsDoNotShare) {
    const Rectilinear<2> grid({even_lines(0, 3, 3), even_lines(0, 3, 3)}, sharing_of<QuadraticElement>());
    std::vector<ImplicitPoint<2>> points(1);
    points[0].x = {1.5, 1.5};
    ActiveGrid<2> active;
    active.sort(grid, points);
    EXPECT_EQ(active.elements, std::vector<int>{4});
    EXPECT_EQ(active.flags, std::vector<int>{1});  // the middle node alone, as the source says
    for (int e = 0; e < 9; ++e) points.emplace_back().x = Vec<2>(e % 3 + 0.5, e / 3 + 0.5);
    active.sort(grid, points);
    EXPECT_EQ(active.flags, std::vector<int>(9, 9));  // there is no empty element
}
TEST(SoftMatrix, SymmetricAndZeroForRigidMotions) {
    const Rectilinear<2> grid({Lines{0, 0.7}, Lines{0, 1.3}}, sharing_of<QuadraticElement>());
    const auto K = soft_matrix<QuadraticElement>(grid, 0);
    ElementVector<double, 2, 9> shift, turn;
    for (int k = 0; k < 9; ++k) {
        const Vec<2> x = grid.position(grid.node(0, k));
        shift.segment<2>(2 * k) = Vec<2>(1, 2);
        turn.segment<2>(2 * k) = Vec<2>(-x[1], x[0]);
    }
    EXPECT_LT((K - K.transpose()).norm(), 1e-13);
    EXPECT_LT((K * shift).norm(), 1e-12);
    EXPECT_LT((K * turn).norm(), 1e-12);
}

}  // namespace
}  // namespace mpm
