// The generalized vortex: the rows of NUMBERS section 13, what costs the printed setting its accuracy, and the balance.
#include "tests/chapters/mms/plane_run.hpp"

namespace mpm::test {
namespace {

/// Particles at Gauss points: as the table's.
VortexCase better() {
    VortexCase ring;
    ring.placing = "gauss";
    return ring;
}
/// The review's: force on the nodes, particles whole, velocities of t = 0 taken for those of -dt/2; with alpha = 0.99.
VortexCase printed() {
    VortexCase ring = better();
    ring.force.at = "nodes";
    ring.cut = "whole";
    ring.start = "whole";
    return ring;
}

// Which particles count as cut is the table's own; the cubic functions, whose reach is longest, feel it most: 5 %, the others 2 %.
TEST(VortexTlmpm, HasTheRowsOfNumbersInThePrintedSetting) {
    EXPECT_NEAR((run_vortex<Hat>(printed(), Flip{0.99}, 50).e2), 0.0878, 0.02 * 0.0878);
    EXPECT_NEAR((run_vortex<Cubic>(printed(), Flip{0.99}, 50).e2), 0.1223, 0.06 * 0.1223);
    EXPECT_NEAR((run_vortex<Bernstein>(printed(), Flip{0.99}, 50, 3).e2), 0.0340, 0.03 * 0.0340);
}
TEST(VortexTlmpm, HasTheRowsOfNumbersInTheBetterSetting) {
    EXPECT_NEAR((run_vortex<Cubic>(better(), Flip{}, 50).e2), 0.0641, 0.05 * 0.0641);
    EXPECT_NEAR((run_vortex<Bernstein>(better(), Flip{}, 50, 3).e2), 0.0142, 0.02 * 0.0142);
}
/// Beyond the force on the nodes it is the lumped mass that costs.
TEST(VortexTlmpm, GainsThreeTimesByFmpm) {
    const double lumped = run_vortex<Cubic>(better(), Flip{}, 50).e2, series = run_vortex<Cubic>(better(), Fmpm{5}, 50).e2;
    EXPECT_GT(lumped / series, 3);
}
/// Centripetal acceleration acts from the start: a whole first impulse sets every later position off by a dt/2 t, of first order; half of
/// it by the second order of the leapfrog. Against the same run with a quarter of the step.
TEST(VortexStart, HalfAnImpulseKeepsTheSecondOrderInTime) {
    const auto ends = [](const char* start, int steps) {
        VortexCase ring;
        ring.start = start;
        const Vortex<true> scene(ring);
        struct Body {
            std::vector<Point<2>> points;
        } body{scene.particles<Point<2>>(10, 2)};
        const double dt = 0.1 / steps;
        for (int k = 0; k < steps; ++k)  // the body force alone, without stress
            for (auto& p : body.points) p.v += dt * scene.part(k * dt) * ring.b(p.X, k * dt), p.x += dt * p.v;
        return body.points;
    };
    const auto off = [&](const char* start, int steps) {
        const auto coarse = ends(start, steps), fine = ends("half", 8 * steps);
        double sum = 0;
        for (std::size_t i = 0; i < fine.size(); ++i) sum += (coarse[i].x - fine[i].x).squaredNorm();
        return std::sqrt(sum);
    };
    EXPECT_NEAR(std::log2(off("half", 20) / off("half", 40)), 2, 0.05);
    EXPECT_NEAR(std::log2(off("whole", 20) / off("whole", 40)), 1, 0.1);
}

/// What changes energy and momentum is what the body force and the held nodes bring in. In the first eighth of the motion the force takes
/// away half of the energy, while the ring shears.
TEST(VortexBalance, Closes) {
    for (const char* at : {"particles", "nodes"})
        for (const char* boundary : {"held", "free"}) {
            VortexCase ring;
            ring.force.at = at;
            ring.boundary = boundary;
            const PlaneRun r = run_vortex<Bernstein>(ring, Flip{}, 50, 2, 0.25);
            EXPECT_NEAR(r.drift, 0, 0.05) << at << ", " << boundary;    // of a half: the last half step, and what mapping twice dissipates
            EXPECT_NEAR(r.momentum, 0, 1e-13) << at << ", " << boundary;  // the ring's is zero: rounding of 55 steps
        }
}

TEST(VortexParticles, FillTheRing) {
    const VortexCase standard;
    const double area = std::numbers::pi * (standard.R_o * standard.R_o - standard.R_i * standard.R_i);
    const auto off = [&](const char* cut, int cells) {
        VortexCase ring;
        ring.cut = cut;
        double V = 0;
        Vec<2> moment = Vec<2>::Zero();
        for (const auto& p : Vortex<true>(ring).particles<Point<2>>(cells, 2)) {
            EXPECT_EQ(p.v, ring.v(p.X, 0));
            EXPECT_DOUBLE_EQ(p.m, ring.rho * p.V0);
            V += p.V0;
            moment += p.V0 * p.X;
        }
        EXPECT_LT(moment.norm(), 1e-13) << cut;
        return std::abs(V - area) / area;
    };
    EXPECT_LT(off("fraction", 20), 1e-4);  // 400 cut boxes, each off by 1e-3 of its own hundredth of a cell's ten-thousandth
    EXPECT_LT(off("fraction", 50), 1e-4);
    EXPECT_LT(off("whole", 20), 0.05);  // the chance of centres
}
TEST(VortexParticles, AreCutWhereTheEdgePasses) {
    const auto cut = [](double x) { return cut_by_ring({Vec<2>(x - 0.5, -0.5), Vec<2>(x + 0.5, 0.5)}, 50, 100); };
    const CutBox half = cut(100), whole = cut(75), none = cut(20);
    EXPECT_NEAR(half.part, 0.5, 1e-3);  // a nearly straight edge through its middle, bent by 1/2400
    EXPECT_NEAR(half.middle[0], 99.75, 0.02);
    EXPECT_NEAR(half.middle[1], 0, 0.02);
    EXPECT_EQ(whole.part, 1);
    EXPECT_EQ(whole.middle, Vec<2>(75, 0));
    EXPECT_EQ(none.part, 0);
}

/// The angle of the middle circle is that of the exact motion, when particles are where they should be.
TEST(Vortex, WatchesTheAngleOfTheMiddleCircle) {
    const VortexCase ring;
    const Vortex<true> scene(ring);
    auto points = scene.particles<Point<2>>(20, 2);
    const double t = 0.3;
    for (auto& p : points) p.x = ring.x(p.X, t);
    const auto angle = scene.watch(points, t);
    EXPECT_NEAR(angle[0], std::sin(0.3 * std::numbers::pi), 1e-14);
    EXPECT_NEAR(angle[1], std::sin(0.3 * std::numbers::pi), 1e-15);
}
TEST(Vortex, RefusesARingWithoutWidth) {
    VortexCase ring;
    ring.R_i = ring.R_o;
    EXPECT_THROW(ring.check(), BadInput);
}

}  // namespace
}  // namespace mpm::test
