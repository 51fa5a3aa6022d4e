// Particle splitting (review 5.6.2): nothing is lost, and the parts fill the domain.
#include "chapters/cpdi/split.hpp"

#include <gtest/gtest.h>

#include "chapters/cpdi/gaps.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "lab/boundary.hpp"
#include "lab/monitor.hpp"

namespace mpm::test {
namespace {

const NeoHookean soft{30, 20, 2};
const Lattice<2> lattice(Vec<2>(-6, -6), Vec<2>(1, 1), {12, 12});

struct Split {
    std::vector<Point<2>> points;
    std::vector<Vec<2>> half;
};
/// One particle with a parallelogram of width 2 half[0] and height 2 half[1], sheared and stretched by F.
Split one(const Vec<2>& half) {
    Split s{std::vector<Point<2>>(1), {half}};
    Point<2>& p = s.points[0];
    p.F << 1.2, 0.3, -0.1, 0.9;
    p.x = Vec<2>(0.3, -0.2), p.v = Vec<2>(1.5, -0.7);
    p.V0 = 4 * half[0] * half[1], p.V = p.V0 * p.F.determinant(), p.m = soft.rho * p.V0;
    soft.update(p, identity<2>(), 0);
    return s;
}
std::vector<Corners2> domains(const Split& s) {
    std::vector<Corners2> all;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        const auto x = DomainR4::corners_of(s.points[i], s.half[i]);
        all.emplace_back(x.begin(), x.end());
    }
    return all;
}

// Equal shares: to rounding.
TEST(Splitting, KeepsMassMomentumEnergyAndCentre) {
    for (const int parts : {2, 3, 5}) {
        const Split whole = one({2, 0.5});
        Split s = whole;
        split_particle(s.points, s.half, 0, 0, parts);
        ASSERT_EQ(s.points.size(), static_cast<std::size_t>(parts));
        double m = 0, V = 0, kinetic = 0, strain = 0;
        Vec<2> mv = Vec<2>::Zero(), mx = Vec<2>::Zero();
        for (const auto& p : s.points) {
            m += p.m, V += p.V, mv += p.m * p.v, mx += p.m * p.x, kinetic += 0.5 * p.m * p.v.squaredNorm(), strain += soft.energy(p);
            EXPECT_EQ(p.sigma, whole.points[0].sigma);
        }
        const auto& p = whole.points[0];
        EXPECT_NEAR(m, p.m, 1e-15 * p.m);
        EXPECT_NEAR(V, p.V, 1e-15 * p.V);
        EXPECT_LT((mv - p.m * p.v).norm(), 1e-14);
        EXPECT_LT((mx / m - p.x).norm(), 1e-15);
        EXPECT_NEAR(kinetic, 0.5 * p.m * p.v.squaredNorm(), 1e-14 * kinetic);
        EXPECT_NEAR(strain, soft.energy(p), 1e-14 * strain);
    }
}
TEST(Splitting, FillsTheDomainOfTheWhole) {
    Split s = one({2, 0.5});
    const std::vector<Corners2> whole = domains(s);
    split_particle(s.points, s.half, 0, 0, 3);
    std::vector<Corners2> parts = domains(s);
    const double area = s.points[0].V * 3;
    EXPECT_NEAR(covered_area(parts), area, 1e-14);  // no overlaps
    parts.push_back(whole[0]);
    EXPECT_NEAR(covered_area(parts), area, 1e-14);  // nothing outside the whole
}
TEST(Splitting, LeavesShortDomainsAlone) {
    Split s = one({1, 0.9});
    EXPECT_FALSE(split_long(s.points, s.half, lattice.h()));
    EXPECT_EQ(s.points.size(), 1u);
}
// No edge of a part spans more than two cells, and a domain long both ways is split both ways.
TEST(Splitting, MakesLongDomainsShort) {
    for (const Vec<2>& half : {Vec<2>(2, 0.5), Vec<2>(0.4, 3), Vec<2>(2.5, 2.5)}) {
        Split s = one(half);
        const std::vector<Corners2> whole = domains(s);
        EXPECT_TRUE(split_long(s.points, s.half, lattice.h()));
        for (std::size_t i = 0; i < s.points.size(); ++i)
            for (const int axis : {0, 1}) EXPECT_LE((2 * s.half[i][axis] * s.points[i].F.col(axis)).cwiseAbs().maxCoeff(), 2);
        const std::vector<Corners2> parts = domains(s);
        EXPECT_NEAR(covered_area(parts), covered_area(whole), 1e-13);
        double m = 0;
        for (const auto& p : s.points) m += p.m;
        EXPECT_NEAR(m, soft.rho * 4 * half[0] * half[1], 1e-13);
    }
}

/// A uniform stretch along x that all nodes are given.
struct Stretching : FreeScene {
    template <class Nodes, class Field> void fix(Nodes& nodes, Field field, double) const {
        for (int I = 0; I < nodes.size(); ++I) nodes[I].*field = nodes[I].m * Vec<2>(lattice.position(I)[0], 0);
    }
};
// In the midst of a run: a domain of one cell is stretched to 3.3 and is then two.
TEST(Splitting, HappensWhenADomainGrowsTooLong) {
    using OneBody = Body<2, Point<2>, Musl::NodeOf<2>, NeoHookean, SplittingParallelograms, Flip>;
    std::vector<Point<2>> points(1);
    points[0].V = points[0].V0 = 1, points[0].m = soft.rho;
    const SplittingParallelograms shape(lattice, points, {Vec<2>(0.5, 0.5)});
    std::vector<OneBody> bodies;
    bodies.push_back(OneBody{{points, Grid<2, Musl::NodeOf<2>>(lattice), soft}, shape, Flip{}});
    for (int n = 0; n < 120; ++n) Musl{}.step(bodies, Free{}, Stretching{}, 0.01 * n, 0.01);
    const OneBody& body = bodies[0];
    ASSERT_EQ(body.points.size(), 2u);
    EXPECT_EQ(body.shape.size(), 2u);
    EXPECT_NEAR(body.points[0].F(0, 0), std::pow(1.01, 120), 1e-12);
    EXPECT_NEAR(body.points[1].x[0] - body.points[0].x[0], std::pow(1.01, 120) / 2, 1e-12);  // still side by side
}

}  // namespace
}  // namespace mpm::test
