// The manufactured square: orders, the rows of NUMBERS section 12, and the balance of what the body force and the walls bring in.
#include "tests/chapters/mms/plane_run.hpp"

namespace mpm::test {
namespace {

SquareCase square(double G) {
    SquareCase s;
    s.G = G;
    return s;
}
/// e2 over one period.
template <class Kernel, class Scheme, class Transfer>
double e2(const SquareCase& s, const Scheme& scheme, const Transfer& transfer, int cells, int ppc = 2) {
    return run_square<Kernel>(s, scheme, transfer, cells, ppc).e2;
}
/// The review's setting with the particles of the table, at Gauss points.
SquareCase printed(double G) {
    SquareCase s = square(G);
    s.force.at = "nodes";
    s.placing = "gauss";
    return s;
}

// Two digits in the table's last rows, hence 2 %.
template <class Kernel> void expect_row(int ppc, double at_8, double at_16) {
    EXPECT_NEAR((e2<Kernel>(printed(0.05), Tlmpm{}, Flip{0.99}, 8, ppc)), at_8, 0.02 * at_8);
    EXPECT_NEAR((e2<Kernel>(printed(0.05), Tlmpm{}, Flip{0.99}, 16, ppc)), at_16, 0.02 * at_16);
}
TEST(SquareTlmpm, HasTheRowsOfNumbersInThePrintedSetting) {
    expect_row<Hat>(2, 0.0664, 0.0170);
    expect_row<Cubic>(2, 0.165, 0.0447);
    expect_row<Bernstein>(3, 0.0480, 0.0118);
}

/// With FLIP alone and the body force at the particles: order two, at any amplitude.
template <class Kernel> void expect_order_two(double low) {
    for (const double G : {1e-4, 0.05}) {
        const double coarse = e2<Kernel>(square(G), Tlmpm{}, Flip{}, 8);
        const double fine = e2<Kernel>(square(G), Tlmpm{}, Flip{}, 16);
        EXPECT_GE(std::log2(coarse / fine), low) << "G = " << G;
        EXPECT_LE(std::log2(coarse / fine), 2.1) << "G = " << G;
    }
}
TEST(SquareTlmpm, ConvergesWithOrderTwo) {
    expect_order_two<Hat>(1.95);
    expect_order_two<Bernstein>(1.95);
    expect_order_two<Cubic>(1.88);  // its h^4 term still shows: 1.91 here, 1.98 to 64 cells (tests/examples)
}
// alpha = 0.99 damps by (1 - alpha) of what the grid cannot hold in every step: that is of first order in h at a fixed fraction of the
// critical step, so that orders fall with h (1.85 to 64 cells: tests/examples).
TEST(SquareTlmpm, LosesOrderWithAPartOfPic) {
    const auto order = [](double alpha) {
        return std::log2(e2<Hat>(square(0.05), Tlmpm{}, Flip{alpha}, 16) / e2<Hat>(square(0.05), Tlmpm{}, Flip{alpha}, 32));
    };
    EXPECT_GT(order(1), 1.99);
    EXPECT_LT(order(0.99), 1.97);
}
// As in one dimension, 2.33e-5/1.2e-6 there: the series sees what lumping the mass smears. (NUMBERS has 5.4e-4 at 32 cells, of order 1.5.)
TEST(SquareTlmpm, GainsFiftyTimesByFmpm) {
    const double lumped = e2<Cubic>(square(0.05), Tlmpm{}, Flip{}, 32);
    const double series = e2<Cubic>(square(0.05), Tlmpm{}, Fmpm{5}, 32);
    EXPECT_GT(lumped / series, 50);
}
/// Review remark 38: e2 does not depend on the amplitude, e1 grows with it.
TEST(SquareNorms, OnlyTheFirstGrowsWithTheAmplitude) {
    const PlaneRun small = run_square<Hat>(square(1e-4), Tlmpm{}, Flip{}, 16), large = run_square<Hat>(square(0.05), Tlmpm{}, Flip{}, 16);
    EXPECT_NEAR(large.e2 / small.e2, 1, 0.05);
    EXPECT_NEAR(large.e1 / small.e1, 500, 30);
}

// The standard MPM: as on the segment it converges while displacements are small, and not at all where they are large.
TEST(SquareUpdated, StandardMpmConvergesAtSmallAmplitudeOnly) {
    const auto ratio = [](double G) { return e2<Hat>(square(G), Musl{}, Flip{}, 8) / e2<Hat>(square(G), Musl{}, Flip{}, 16); };
    EXPECT_NEAR(std::log2(ratio(1e-4)), 2, 0.1);
    EXPECT_LT(ratio(0.05), 1);
}
TEST(SquareUpdated, StretchingGimpConverges) {
    const double coarse = e2<Cpgimp>(square(0.05), Usl{}, Flip{}, 8), fine = e2<Cpgimp>(square(0.05), Usl{}, Flip{}, 16);
    EXPECT_GT(std::log2(coarse / fine), 1.8);
}

/// What a scheme's energy and momentum change by over a quarter of a period is what the body force and the walls bring in.
template <class Kernel, class Scheme> void expect_balance(const Scheme& scheme) {
    for (const char* at : {"particles", "nodes"}) {
        SquareCase s = square(1e-3);
        s.force.at = at;
        const PlaneRun r = run_square<Kernel>(s, scheme, Flip{}, 16, 2, 0.25);
        EXPECT_NEAR(r.kinetic, 0.5 * s.rho * std::pow(s.omega() * s.G, 2), 1e-3 * r.kinetic);  // two axes of 1/4 each
        EXPECT_NEAR(r.drift, 0, 0.02) << Scheme::name << ", " << at;                            // half a step of the last kick
        EXPECT_NEAR(r.momentum, 0, 1e-13) << Scheme::name << ", " << at;                        // rounding of 80 steps
    }
}
TEST(SquareBalance, Closes) {
    expect_balance<Hat>(Tlmpm{});
    expect_balance<Hat>(Musl{});
    expect_balance<Hat>(Usl{});
    expect_balance<Cubic>(Usf{});
}

TEST(Square, FillsItself) {
    for (const char* placing : {"mid", "gauss"})
        for (const int ppc : {1, 2, 3}) {
            SquareCase s;
            s.placing = placing;
            double V = 0, m = 0;
            Vec<2> moment = Vec<2>::Zero();
            for (const auto& p : Square<true>(s).particles<Point<2>>(5, ppc)) {
                V += p.V0;
                m += p.m;
                moment += p.V0 * p.X;
                EXPECT_EQ(p.v, s.v(p.X, 0));
            }
            EXPECT_NEAR(V, 1, 1e-14);
            EXPECT_NEAR(m, 1000, 1e-11);
            EXPECT_LT((moment - Vec<2>(0.5, 0.5)).norm(), 1e-14);
        }
}
TEST(Square, RefusesToTurnInsideOut) {
    EXPECT_THROW(square(0.32).check(), BadInput);  // above 1/pi
    EXPECT_NO_THROW(square(0.31).check());
}

}  // namespace
}  // namespace mpm::test
