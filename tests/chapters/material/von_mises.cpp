// Elasto-plasticity of von Mises: closed forms on simple paths, the yield surface, energy, objectivity. Any consistent units.
#include "chapters/material/von_mises.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "chapters/material/linear_elastic.hpp"
#include "chapters/material/materials.hpp"
#include "tests/chapters/material/point.hpp"

namespace mpm::test {
namespace {

using Plain = VonMisesWith<StressRate::plain>;  // its strain is the sum of the steps', as small-strain closed forms take it
constexpr double lambda = 120, mu = 80, yield = 0.3, K = lambda + 2 * mu / 3;

template <class Law> Law metal(double H = 0) { return {lambda, mu, 1, yield, H}; }
Mat<2> stretch(double xx, double yy = 0) { return Mat<2>{{xx, 0}, {0, yy}}; }
Mat<2> shear(double xy) { return Mat<2>{{0, xy}, {xy, 0}}; }
template <class Point> double deviator_norm(const Point& p) {
    const double m = (p.sigma.trace() + p.sigma33) / 3;
    return std::sqrt((p.sigma - m * identity<2>()).squaredNorm() + (p.sigma33 - m) * (p.sigma33 - m));
}

/// Axial stress of uniaxial strain e > 0 from the virgin state: elastic with lambda + 2 mu until 2 mu e = yield; then s_xx = 2/3 flow,
/// where the flow stress grows by H deps_p and 2 mu (2/3 e - eps_p) = 2/3 flow.
double uniaxial(double e, double H) {
    if (2 * mu * e <= yield) return (lambda + 2 * mu) * e;
    const double eps_p = (2 * mu * e - yield) / (3 * mu + H);
    return K * e + 2.0 / 3 * (yield + H * eps_p);
}
TEST(VonMises, UniaxialStrainFollowsTheClosedForm) {
    for (const double H : {0.0, 7.0}) {
        auto line = unit_point<1, Plain>();
        auto plane = unit_point<2, Plain>();
        const Plain law = metal<Plain>(H);
        for (int k = 1; k <= 50; ++k) {
            const double e = k * 2e-4;  // yields at 1.875e-3, between two steps: the return is exact for a constant direction
            law.update(line, Mat<1>(Mat<1>::Constant(2e-4)), 1);
            law.update(plane, stretch(2e-4), 1);
            const double exact = uniaxial(e, H);
            EXPECT_NEAR(line.sigma(0, 0), exact, 1e-13);  // 50 additions of numbers of order 1
            EXPECT_NEAR(plane.sigma(0, 0), exact, 1e-13);
            EXPECT_NEAR(plane.sigma(1, 1), line.sigma33, 1e-13);  // symmetric about the axis
            EXPECT_NEAR(plane.sigma33, line.sigma33, 1e-13);
            EXPECT_NEAR(plane.eps_p, line.eps_p, 1e-15);
        }
    }
}

TEST(VonMises, PureShearYieldsAtYieldOverRootThree) {
    const Plain law = metal<Plain>();
    auto p = unit_point<2, Plain>();
    const double step = 1e-4, first = yield / std::sqrt(3.0);
    for (int k = 1; k <= 100; ++k) {
        law.update(p, shear(step), 1);
        EXPECT_NEAR(p.sigma(0, 1), std::min(2 * mu * step * k, first), 1e-14);
        EXPECT_NEAR(p.eps_p, std::max(0.0, 2 / std::sqrt(3.0) * (step * k - first / (2 * mu))), 1e-15);  // gamma_p/sqrt(3)
        EXPECT_EQ(p.sigma33, 0);
    }
}

TEST(VonMises, UnloadsElasticallyAndYieldsAgainWhereItStopped) {
    const double H = 7;
    const Plain law = metal<Plain>(H);
    auto p = unit_point<2, Plain>();
    law.update(p, shear(5e-3), 1);
    const double shear_stress = p.sigma(0, 1), eps_p = p.eps_p;
    ASSERT_GT(eps_p, 0);
    law.update(p, shear(-1e-3), 1);
    EXPECT_NEAR(p.sigma(0, 1), shear_stress - 2 * mu * 1e-3, 1e-15);
    law.update(p, shear(1e-3), 1);
    EXPECT_NEAR(p.sigma(0, 1), shear_stress, 1e-15);
    EXPECT_NEAR(p.eps_p, eps_p, 1e-16);
    law.update(p, shear(1e-3), 1);
    // d tau = H/3 gamma_p, elastic and plastic in series
    EXPECT_NEAR(p.sigma(0, 1) - shear_stress, 2 * mu * H / (3 * mu + H) * 1e-3, 1e-15);
}

// The stress across the plane grows with the pressure and takes part in yielding: in-plane stress alone would leave the surface.
TEST(VonMises, PlaneStrainStaysOnTheYieldSurface) {
    for (const double H : {0.0, 7.0}) {
        const VonMises law = metal<VonMises>(H);
        auto p = unit_point<2, VonMises>();
        int plastic = 0;
        for (int k = 0; k < 400; ++k) {
            const double eps_p = p.eps_p;
            strain(law, p, Mat<2>{{3e-3 * std::cos(0.05 * k), 1e-3}, {2e-3 * std::sin(0.11 * k), -1e-3}});
            const double radius = std::sqrt(2.0 / 3) * (yield + H * p.eps_p);
            EXPECT_LE(deviator_norm(p), radius * (1 + 1e-12));
            if (p.eps_p == eps_p) continue;
            ++plastic;
            EXPECT_NEAR(deviator_norm(p), radius, 1e-12 * std::max(1.0, p.sigma.norm()));
            EXPECT_NEAR(law.mises(p), yield + H * p.eps_p, 1e-12 * std::max(1.0, p.sigma.norm()));
        }
        EXPECT_GT(plastic, 300);
        EXPECT_GT(std::abs(p.sigma33), 0.1);
    }
}

TEST(VonMises, HugeStepsReturnToTheSurface) {
    for (const double size : {1.0, 1e6, 1e100}) {
        const Plain law = metal<Plain>(7);
        auto p = unit_point<2, Plain>();
        law.update(p, shear(size), 1);
        const double radius = std::sqrt(2.0 / 3) * (yield + 7 * p.eps_p);
        EXPECT_NEAR(deviator_norm(p) / radius, 1, 1e-12);
        EXPECT_NEAR(p.eps_p / size, 2 * mu * std::sqrt(3.0) / (3 * mu + 7), 0.01 / size + 1e-12);  // the yield stress no longer matters
    }
}

TEST(VonMises, NothingHappensToARestingPoint) {
    const VonMises law = metal<VonMises>();
    auto p = unit_point<2, VonMises>();
    strain(law, p, Mat<2>(Mat<2>::Zero()));
    EXPECT_EQ(p.sigma, Mat<2>(Mat<2>::Zero()));
    EXPECT_EQ(p.eps_p, 0);
    EXPECT_EQ(law.energy(p), 0);
    EXPECT_EQ(law.mises(p), 0);
}

TEST(VonMises, PressureAloneNeverYieldsAndHydrostaticStressIsNotReturned) {
    const VonMises soft{0, 0.5, 1, 0, 0};  // a yield stress of zero: a fluid
    auto p = unit_point<2, VonMises>();
    strain(soft, p, stretch(-0.1, 0.02));
    EXPECT_NEAR(p.sigma(0, 0), p.sigma33, 1e-16);
    EXPECT_NEAR(p.sigma(1, 1), p.sigma33, 1e-16);
    EXPECT_LT(p.sigma33, -0.01);
}

TEST(VonMises, NearlyIncompressibleMetalKeepsItsYieldStress) {
    const VonMises law{1e8, 80, 1, yield, 0};
    auto p = unit_point<2, VonMises>();
    for (int k = 0; k < 200; ++k) strain(law, p, stretch(1e-3, -1e-3 / (1 + 1e-3)));
    EXPECT_NEAR(law.mises(p), yield, 1e-7);  // the pressure, up to 1e8 x rounding of a strain of 0.2, takes digits from the deviator
    EXPECT_NEAR(p.eps_p, 2 / std::sqrt(3.0) * 200 * std::log1p(1e-3), 2 * yield / mu);  // less the elastic part
}

TEST(VonMises, WithoutYieldStressIsLinearElastic) {
    const Plain law{lambda, mu, 1};
    const LinearElastic elastic{lambda, mu, 1};
    auto p = unit_point<2, Plain>();
    auto q = unit_point<2, LinearElastic>();
    for (int k = 0; k < 20; ++k) {
        const Mat<2> L{{0.3 * k, 0.1}, {-0.2, 0.5}};
        law.update(p, L, 1e-2);
        elastic.update(q, L, 1e-2);
        EXPECT_EQ(p.sigma, q.sigma);
    }
    EXPECT_EQ(p.eps_p, 0);
    EXPECT_EQ(p.plastic_work, 0);
}

/// Stored and dissipated energy less the work done along a smooth path of n steps without change of volume, relative to the work.
template <class Law> double unaccounted(const Law& law, int n) {
    auto p = unit_point<2, Law>();
    double work = 0;
    for (int k = 0; k < n; ++k) {
        const double t = (k + 0.5) / n;
        work += strain(law, p, Mat<2>(Mat<2>{{-0.5 * t, 1.2 * std::cos(5 * t)}, {-1.6 * t, 0.5 * t}} / n));
    }
    EXPECT_GT(p.plastic_work, 0.1 * work);
    return (law.energy(p) + law.dissipated(p) - work) / work;
}
// The return takes the stress at the end of a step for the whole step. Without hardening only its direction differs.
TEST(VonMises, EnergyBalanceClosesInFirstOrder) {
    const VonMises hard = metal<VonMises>(7), ideal = metal<VonMises>();
    const double coarse = unaccounted(hard, 400), fine = unaccounted(hard, 800);
    EXPECT_LT(std::abs(fine), 2e-3);
    EXPECT_NEAR(std::log2(coarse / fine), 1, 0.05);
    EXPECT_LT(std::abs(unaccounted(ideal, 800)), std::abs(0.5 * unaccounted(ideal, 400)));
}
TEST(VonMises, PlasticWorkIsThatOfTheCurrentVolume) {
    const VonMises law = metal<VonMises>();
    auto p = unit_point<2, VonMises>();
    p.V = 0.5;
    law.update(p, shear(0.01), 1);
    EXPECT_NEAR(p.plastic_work, 0.5 * yield * p.eps_p, 1e-16);
}
// The mean stress K ln J works on the current volume, of which its energy is the exact integral at any compression.
TEST(VonMises, ElasticEnergyIsTheWorkOfThePressure) {
    const VonMises elastic{lambda, mu, 1};
    for (const double steps : {200.0, 400.0}) {
        auto p = unit_point<2, VonMises>();
        double work = 0;
        const double part = std::pow(0.7, 1 / steps) - 1;
        for (int k = 0; k < static_cast<int>(steps); ++k) work += strain(elastic, p, stretch(part, part));
        const double deviatoric = elastic.mises(p) * elastic.mises(p) / (6 * mu) * p.V;
        EXPECT_NEAR(work / elastic.energy(p), 1, 0.35 * deviatoric / elastic.energy(p));  // s:s/(4 mu) takes the volume for constant
    }
}

/// The stress after n turns by theta each, together 360 degrees, from `sigma`; as schemes hand them over: exact nodal velocities.
template <class Law> auto turned(const Law& law, const Mat<2>& sigma, int n, bool total = false) {
    auto p = unit_point<2, Law>();
    p.sigma = sigma;
    const double theta = 2 * std::numbers::pi / n, c = std::cos(theta), s = std::sin(theta);
    const Mat<2> R{{c, -s}, {s, c}};
    for (int k = 0; k < n; ++k) law.update(p, total ? Mat<2>(identity<2>() - R.transpose()) : Mat<2>(R - identity<2>()), 1);
    return p;
}
const Mat<2> stressed{{0.1, 0.05}, {0.05, -0.08}};  // below yield

TEST(VonMises, StressTurnsWithTheBody) {
    for (const int n : {4, 7, 1000}) {  // exactly, for quarter turns a step as well
        const double rounding = 1e-13 * (lambda + 2 * mu);  // of 1000 strains
        EXPECT_LT((turned(metal<VonMises>(), stressed, n).sigma - stressed).norm(), rounding);
        const auto total = metal<VonMisesWith<StressRate::corotated_total>>();
        EXPECT_LT((turned(total, stressed, n, true).sigma - stressed).norm(), rounding);
    }
    // a quarter of the circle exchanges the axes
    const VonMises law = metal<VonMises>();
    auto p = unit_point<2, VonMises>();
    p.sigma = stressed;
    law.update(p, Mat<2>(Mat<2>{{0, -1}, {1, 0}} - identity<2>()), 1);
    EXPECT_LT((p.sigma - Mat<2>{{-0.08, -0.05}, {-0.05, 0.1}}).norm(), 1e-15);
}
// The plain rate strains by cos(theta) - 1 on both axes a step: 2 pi^2/n over a circle, 0.0197 for 1000 steps, a pressure of (lambda +
// mu) times twice that: above yield in nothing but pressure.
TEST(VonMises, PlainRateMakesPressureOfATurn) {
    const int n = 1000;
    const auto p = turned(Plain{lambda, mu, 1}, stressed, n);
    const double e = n * (std::cos(2 * std::numbers::pi / n) - 1);
    EXPECT_NEAR(e, -2 * std::numbers::pi * std::numbers::pi / n, 1e-6);
    EXPECT_LT((p.sigma - stressed - 2 * (lambda + mu) * e * identity<2>()).norm(), 1e-11);
    EXPECT_NEAR(p.sigma33, 2 * lambda * e, 1e-11);
}

Mat<2> rotation(double theta) { return Mat<2>{{std::cos(theta), -std::sin(theta)}, {std::sin(theta), std::cos(theta)}}; }

/// A plastic path, at rest and seen from a frame that turns by 200 degrees meanwhile (F -> Q F), 20 degrees a step.
TEST(VonMises, SuperposedRotationChangesNothing) {
    const VonMises law = metal<VonMises>(7);
    const double theta = std::numbers::pi / 9;
    auto still = unit_point<2, VonMises>(), turning = still;
    for (int k = 0; k < 10; ++k) {
        const Mat<2> G{{0.2, 0.3 - 0.1 * k}, {-0.1, -0.15}};
        strain(law, still, G);
        strain(law, turning, Mat<2>(rotation((k + 1) * theta) * (identity<2>() + G) * rotation(-k * theta) - identity<2>()));
    }
    const Mat<2> Q = rotation(10 * theta);
    EXPECT_LT((turning.sigma - Q * still.sigma * Q.transpose()).norm(), 1e-13 * (lambda + 2 * mu));  // rounding of strains
    EXPECT_NEAR(turning.sigma33, still.sigma33, 1e-13 * (lambda + 2 * mu));
    EXPECT_NEAR(turning.eps_p, still.eps_p, 1e-13);
    EXPECT_NEAR(turning.plastic_work, still.plastic_work, 1e-12);
}
// The same steps seen by an updated- and by a total-Lagrangian scheme, dt L = G and G (I + G)^-1.
TEST(VonMises, BothConfigurationsGiveTheSameStress) {
    const VonMises updated = metal<VonMises>(7);
    const auto total = metal<VonMisesWith<StressRate::corotated_total>>(7);
    auto p = unit_point<2, VonMises>();
    auto q = unit_point<2, VonMisesWith<StressRate::corotated_total>>();
    for (int k = 0; k < 10; ++k) {
        const Mat<2> G{{0.2, 0.3 - 0.1 * k}, {-0.1, -0.15}};
        updated.update(p, G, 1);
        total.update(q, Mat<2>(G * (identity<2>() + G).inverse()), 1);
    }
    EXPECT_LT((p.sigma - q.sigma).norm(), 1e-13 * (lambda + 2 * mu));
    EXPECT_NEAR(p.eps_p, q.eps_p, 1e-13);
}
TEST(VonMises, MeanStressIsThatOfTheVolume) {  // K ln J with tr ln U = ln J
    const VonMises elastic{lambda, mu, 1};
    auto p = unit_point<2, VonMises>();
    for (int k = 0; k < 100; ++k) strain(elastic, p, Mat<2>{{3e-3, 0.01}, {-0.02, 1e-3}});
    EXPECT_NEAR((p.sigma.trace() + p.sigma33) / 3 / (K * std::log(p.V)), 1, 1e-4);  // (U - I)^2/12 with strains of 0.01 a step
}

TEST(Materials, ShowWhatTheLawOfTheParticleShows) {
    using Two = Materials<VonMises>;
    static_assert(Two::columns.size() == 1 && Materials<LinearElastic>::columns.empty());
    const Two laws{{VonMises{lambda, mu, 1}, metal<VonMises>()}};
    auto p = unit_point<2, Two>();
    p.material = 1;
    for (int k = 0; k < 10; ++k) laws.update(p, shear(1e-3), 1);
    EXPECT_GT(p.eps_p, 0);
    EXPECT_EQ(laws.values(p)[0], p.eps_p);
    EXPECT_EQ(laws.sigma_zz(p), p.sigma33);
    p = unit_point<2, Two>();  // the first one is elastic
    for (int k = 0; k < 10; ++k) laws.update(p, shear(1e-3), 1);
    EXPECT_EQ(laws.values(p)[0], 0);
}

}  // namespace
}  // namespace mpm::test
