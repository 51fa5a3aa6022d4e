#include "chapters/contact/bardenhagen.hpp"

#include "chapters/explicit/usf.hpp"
#include "tests/chapters/contact/pieces.hpp"

namespace mpm::test {
namespace {

using Two = Pieces<Usf>;

TEST(Correction, TakesTheNormalPartAndLeavesTheOtherWithoutFriction) {
    const Vec<2> n = Vec<2>(3, 4) / 5, dv(2, 1);
    const auto [pushes, rubs] = correction<2>(dv, n, 0);
    EXPECT_NEAR(pushes, dv.dot(n), 1e-15);
    EXPECT_EQ(rubs.norm(), 0);
}
TEST(Correction, IsCoulombs) {
    const Vec<2> n(0, 1), dv(2, 1);
    EXPECT_NEAR(correction<2>(dv, n, 0.3).rubs[0], 0.3, 1e-15);  // slides: mu D
    EXPECT_EQ(correction<2>(dv, n, 1e6).rubs[0], 2);             // sticks
    EXPECT_EQ(correction<2>(Vec<2>(2, -1), n, 0.3).pushes, 0);   // parts
}
// (5.8) as printed, with its own letters.
TEST(Correction, IsThatOfTheReviewInTwoDimensions) {
    const Vec<2> n = Vec<2>(0.6, 0.8), dv(1.3, 0.4);
    const double mu = 0.2, D = dv.dot(n), C = dv[0] * n[1] - dv[1] * n[0], m = std::min(mu, std::abs(C) / D);
    const Vec<2> printed = D * (n + m / std::abs(C) * Vec<2>(n[1] * C, -n[0] * C));
    const auto [pushes, rubs] = correction<2>(dv, n, mu);
    EXPECT_LT((pushes * n + rubs - printed).norm(), 1e-15);
}

struct Way {
    const char *normals, *common, *gap;
};
const std::vector<Way> ways = [] {
    std::vector<Way> all;
    for (const char* normals : {"gradient", "volume", "density", "regression"})
        for (const char* common : {"on", "off"})
            for (const char* gap : {"velocity", "position", "extent"}) all.push_back({normals, common, gap});
    return all;
}();

/// Runs the same bodies with contact and without, and asks for the same velocities to the last bit.
void expect_nothing_felt(const Two& start) {
    Two alone = start;
    Free none;
    alone.run(none, 5, 1e-3);
    for (const Way& way : ways) {
        Two together = start;
        Bardenhagen<2> contact(choice(way.normals, way.common, way.gap));
        together.run(contact, 5, 1e-3);
        for (std::size_t b = 0; b < 2; ++b)
            for (std::size_t i = 0; i < alone.bodies[b].points.size(); ++i)
                ASSERT_EQ(alone.bodies[b].points[i].v, together.bodies[b].points[i].v) << way.normals << " " << way.common << " " << way.gap;
    }
}
TEST(Contact, BodiesFarApartFeelNothing) {
    Two s;
    s.add({0.2, 0.2}, {0.6, 0.6}, {1, 0});
    s.add({0.9, 0.2}, {1.3, 0.6}, {-1, 0.5});
    expect_nothing_felt(s);
}
TEST(Contact, BodiesThatMoveAwayFeelNothing) {
    Two s;
    s.add({0.2, 0.2}, {0.6, 0.6}, {-1, 0});
    s.add({0.6, 0.2}, {1.0, 0.6}, {1, 0});
    expect_nothing_felt(s);
}

/// Two, three and four bodies around the node at (1, 1), which all share it.
Two crowd(int count) {
    Two s;
    s.add({0.6, 0.6}, {1, 1}, {1, 1});
    if (count == 2) s.add({1, 0.6}, {1.4, 1.4}, {-1, 0});
    if (count == 3) s.add({1, 0.6}, {1.4, 1}, {-1, 1}, 2), s.add({0.6, 1}, {1.4, 1.4}, {0, -1}, 3);
    if (count == 4) s.add({1, 0.6}, {1.4, 1}, {-1, 1}, 2), s.add({0.6, 1}, {1, 1.4}, {1, -1}, 3), s.add({1, 1}, {1.4, 1.4}, {-1, -1}, 4);
    s.stir(0.3);
    return s;
}
// Every pair keeps its momentum, sweep after sweep: 1e-12 is required; what is left is the rounding of 20 steps.
TEST(Contact, OfTwoToFourBodiesConservesMomentumWithCommonNormals) {
    for (const int count : {2, 3, 4})
        for (const Way& way : ways) {
            if (std::string(way.common) == "off") continue;
            Two s = crowd(count);
            const Vec<2> before = s.momentum();
            Bardenhagen<2> contact(choice(way.normals, way.common, way.gap));
            s.run(contact, 20, 1e-3);
            EXPECT_GT(contact.log->pressed, 0.01) << count << way.normals << way.gap;
            EXPECT_LT((s.momentum() - before).norm(), 1e-12 * s.in_play()) << count << way.normals << way.gap;
        }
}
// As printed it is not conserved, and the log says by how much.
TEST(Contact, AsPrintedMakesMomentumAndSaysHowMuch) {
    Two s = crowd(3);
    const Vec<2> before = s.momentum();
    Bardenhagen<2> contact(choice("gradient", "off", "velocity"));
    s.run(contact, 20, 1e-3);
    EXPECT_GT((s.momentum() - before).norm(), 1e-3 * s.in_play());
    EXPECT_LT((s.momentum() - before - contact.log->made).norm(), 1e-12 * s.in_play());
}
// With two bodies the pair's impulse gives both the normal velocity of the centre of mass (5.5, remark 31).
TEST(Contact, OfTwoBodiesGivesTheNormalVelocityOfTheCentreOfMass) {
    Two s;
    s.add({0.6, 0.6}, {1, 1}, {1, 0.2});
    s.add({1, 0.6}, {1.4, 1}, {-1, 0}, 3);
    Bardenhagen<2> contact(choice("volume", "on", "velocity", 0));
    s.run(contact, 1, 1e-6);
    const int I = 8 * 21 + 10;  // (1, 0.8)
    const auto &a = s.bodies[0].grid[I], &b = s.bodies[1].grid[I];
    EXPECT_NEAR(a.v_new[0], -0.5, 1e-12);  // (1 - 3)/4
    EXPECT_NEAR(b.v_new[0], -0.5, 1e-12);
    EXPECT_NEAR(a.v_new[1], 0.2, 1e-12);
    EXPECT_NEAR(b.v_new[1], 0, 1e-12);
}
// No friction, sticking, a heavy partner, a body of one row between two others, faces that coincide: defined, and momentum is kept.
TEST(Contact, AtTheEdgesIsDefined) {
    for (const double mu : {0.0, 1e6})
        for (const double density : {1.0, 1e6})
            for (const Way& way : ways) {
                if (std::string(way.common) == "off") continue;
                Two s;
                s.add({0.6, 0.6}, {1.4, 1}, {0.3, 1});
                s.add({0.6, 1}, {1.4, 1.04}, {0, 0});  // one row of particles, half a cell thick
                s.add({0.6, 1.05}, {1.4, 1.4}, {-0.3, -1}, density);
                const Vec<2> before = s.momentum();
                Bardenhagen<2> contact(choice(way.normals, way.common, way.gap, mu));
                s.run(contact, 10, 1e-3);
                EXPECT_TRUE(s.momentum().allFinite());
                EXPECT_LT((s.momentum() - before).norm(), 1e-12 * s.in_play()) << way.normals << way.gap << mu << density;
            }
}

// A wall takes what a body loses: by the log as by the particles. A plane and rigid particles on it are the same wall.
TEST(RigidWall, TakesTheMomentumThatTheBodyLoses) {
    RigidWall<2> plane, rows;
    plane.at = Vec<2>(0, 0.6), plane.normal = Vec<2>(0, 1);
    rows.spacing = h / 2;
    for (double x = 0.025; x < 2; x += rows.spacing) rows.X.emplace_back(x, 0.575), rows.X.emplace_back(x, 0.525);
    std::vector<Vec<2>> ends;
    for (const RigidWall<2>& wall : {plane, rows}) {
        Two s;
        s.add({0.6, 0.6}, {1, 1}, {0.5, -1});
        const Vec<2> before = s.momentum();
        Bardenhagen<2> contact(choice("regression", "on", "extent"), {wall});
        s.run(contact, 20, 1e-3);
        const Supply supply = contact.supply();
        EXPECT_GT(supply.impulse[1], 0.05);
        EXPECT_LT((s.momentum() - before - Vec<2>(supply.impulse[0], supply.impulse[1])).norm(), 1e-13);
        EXPECT_LT(supply.impulse[0], 0);
        EXPECT_LE(-supply.impulse[0], 0.3 * supply.impulse[1] * (1 + 1e-12));  // Coulomb's law
        ends.push_back(s.momentum());
    }
    EXPECT_LT((ends[0] - ends[1]).norm(), 0.1 * ends[0].norm());  // normals at the body's corners differ by some degrees
}
// Seen from a wall that moves, it is the same impact; its work is its impulse times its velocity. The wall moves by 1/400 of a cell, which
// changes the weights by as much; it overlaps from the start, so that rounding does not tell when they touch.
TEST(RigidWall, ThatMovesIsOneAtRestInItsOwnFrame) {
    std::vector<double> impulse;
    for (const double speed : {0.0, 0.5}) {
        Two s;
        s.add({0.6, 0.6}, {1, 1}, {0, -1 + speed});
        RigidWall<2> wall;
        wall.at = Vec<2>(0, 0.601), wall.normal = Vec<2>(0, 1), wall.motion.v0 = Vec<2>(0, speed);
        Bardenhagen<2> contact(choice("regression", "on", "extent"), {wall});
        s.run(contact, 5, 1e-4);
        const Supply supply = contact.supply();
        EXPECT_NEAR(supply.work, speed * supply.impulse[1], 1e-15);
        impulse.push_back(supply.impulse[1]);
    }
    EXPECT_GT(impulse[0], 0.01);
    EXPECT_NEAR(impulse[1] / impulse[0], 1, 0.01);
}

}  // namespace
}  // namespace mpm::test
