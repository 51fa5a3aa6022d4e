// The manufactured segment by total-Lagrangian schemes: the rows of NUMBERS (two or three digits there, so 5 % here), and order two.
#include "tests/chapters/mms/segment_run.hpp"

namespace mpm::test {
namespace {

void expect_row(double e1, double row) { EXPECT_NEAR(e1, row, 0.05 * row); }

TEST(SegmentFem, HasTheRowsOfNumbers) {
    expect_row(run_segment<TotalFem>(segment_settings(1e-4, 1), 64).e1, 2.27e-8);
    expect_row(run_segment<TotalFem>(segment_settings(1e-4, 2), 64).e1, 2.82e-8);
    expect_row(run_segment<TotalFem>(segment_settings(0.05, 1), 64).e1, 1.20e-5);
    expect_row(run_segment<TotalFem>(segment_settings(0.05, 2), 64).e1, 1.41e-5);
}
TEST(SegmentTlmpm, HasTheRowsOfNumbers) {
    expect_row(e1<Tlmpm>(1e-4, 64), 1.10e-7);
    expect_row(e1<Tlmpm>(0.05, 64), 5.4e-5);
    expect_row(e1<Tlmpm, Cubic>(1e-4, 64), 2.9e-7);
    expect_row(e1<Tlmpm, Cubic>(0.05, 64), 1.4e-4);
    const auto gauss = [](double G) { return segment_settings(G, 3, "gauss"); };  // those of the row; 2 mid ones give 6.7e-8 and 3.2e-5
    expect_row(run_segment<Tlmpm, Bernstein>(gauss(1e-4), 64).e1, 7.2e-8);
    expect_row(run_segment<Tlmpm, Bernstein>(gauss(0.05), 64).e1, 3.6e-5);
}

TEST(SegmentFem, ConvergesWithOrderTwo) {
    for (const double G : {1e-4, 0.05})
        for (const int gauss : {1, 2}) expect_order<TotalFem>(segment_settings(G, gauss), 1.97, 2.03);
    for (const double G : {1e-4, 0.05}) expect_order<UpdatedFem>(segment_settings(G), 1.97, 2.03);
}
TEST(SegmentTlmpm, ConvergesWithOrderTwo) {
    for (const double G : {1e-4, 0.05}) {
        expect_order<Tlmpm>(segment_settings(G), 1.97, 2.03);
        expect_order<Tlmpm, Cubic>(segment_settings(G), 1.93, 2.03);  // 16 cells are few for it
        expect_order<Tlmpm, Bernstein>(segment_settings(G, 3, "gauss"), 1.95, 2.05);
    }
}
// The space error of quadratic elements is of order four: with 0.2 h/c what is left is the leapfrog's, 14 times below the linear
// elements' error.
TEST(SegmentFem, QuadraticElementsLeaveTheErrorOfTheTimeStep) {
    expect_order<TotalFem, Lagrange2>(segment_settings(0.05), 1.97, 2.03);
    EXPECT_LT((e1<TotalFem, Lagrange2>(0.05, 64)), e1<TotalFem>(0.05, 64) / 13);
}

/// Another amplitude, stiffness, Poisson's ratio, density, and two half waves; the second mode sees half as many cells per wave.
template <class Scheme> void expect_order_elsewhere() {
    struct Case {
        double G, E, nu, rho;
        int mode;
    };
    for (const Case& c : {Case{0.01, 1e7, 0.3, 1000, 1}, Case{0.05, 210, 0.45, 7.8, 1}, Case{0.05, 1e9, 0, 2000, 1},
                          Case{1e-4, 1e7, 0.3, 1000, 2}, Case{0.04, 50, 0.2, 3, 2}}) {
        SegmentSettings s = segment_settings(c.G);
        s.scene.E = c.E;
        s.scene.nu = c.nu;
        s.scene.rho = c.rho;
        s.scene.mode = c.mode;
        SCOPED_TRACE("G = " + std::to_string(c.G) + ", nu = " + std::to_string(c.nu) + ", mode " + std::to_string(c.mode));
        expect_order<Scheme>(s, 1.9, 2.1);
    }
}
TEST(SegmentFem, ConvergesElsewhereToo) { expect_order_elsewhere<TotalFem>(); }
TEST(SegmentTlmpm, ConvergesElsewhereToo) { expect_order_elsewhere<Tlmpm>(); }

/// Forces at the nodes, m_I b(X_I), differ from the integrals by their second derivative: the same order.
TEST(SegmentForce, AtTheNodesConvergesToo) {
    SegmentSettings s = segment_settings(0.05);
    s.scene.force = "nodes";
    expect_order<TotalFem>(s, 1.97, 2.03);
    expect_order<Tlmpm>(s, 1.97, 2.03);
}

/// Review remark 38: e2 does not depend on the amplitude, e1 grows with it.
TEST(SegmentNorms, OnlyTheFirstGrowsWithTheAmplitude) {
    const SegmentRun small = run_segment<Tlmpm>(segment_settings(1e-4), 32), large = run_segment<Tlmpm>(segment_settings(0.05), 32);
    EXPECT_NEAR(large.e2 / small.e2, 1, 0.05);
    EXPECT_NEAR(large.e1 / small.e1, 500, 25);
    EXPECT_LT(small.rmse, 0.6 * small.e1) << "a mean over time";
}

}  // namespace
}  // namespace mpm::test
