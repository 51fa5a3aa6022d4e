// The column of the report in its three cases, against NUMBERS section 5, its exact solutions and finite elements.
#include "chapters/explicit/tlmpm_column/column.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>

#include "chapters/fem/total.hpp"
#include "chapters/scenes/column_defaults.hpp"
#include "lab/run.hpp"

namespace mpm::test {
namespace {

constexpr double pi = std::numbers::pi;

struct Outcome {
    std::map<std::string, double> error;
    double u_end = 0, kept_quarter = 0, kept = 0, energy_drift = 0, momentum_drift = 0;
    bool ok = false;
};
/// A case as the report has it, to be changed.
struct Report {
    ColumnCase column;
    Common common;
    explicit Report(const std::string& which) : column(column_case(which)) { set_defaults(common, column); }
    Report& cells(int n) { return common.cells = {n}, *this; }
    Report& damping(double d) { return column.damping = d, *this; }
    Report& start(const std::string& how) { return column.start = how, *this; }
};

template <class Kernel, class Law, class Scheme, class Transfer>
Outcome run_column(const Report& s, const Scheme& scheme, const Transfer& transfer) {
    Assembled a = assemble_with<Kernel, true>(scheme, Column<Law>(s.column), transfer, s.common.cells[0], s.common);
    RunPlan plan;
    plan.steps = static_cast<long>(std::ceil(s.common.t_end / (s.common.cfl * a.critical_dt) * (1 - 1e-12)));
    plan.dt = s.common.t_end / static_cast<double>(plan.steps);
    plan.t_end = s.common.t_end;
    plan.folder = testing::TempDir() + "column-" + std::to_string(getpid());
    std::filesystem::create_directories(plan.folder);
    plan.columns = s.column.columns();
    plan.critical_dt = a.critical_dt;
    const RunResult r = run(a.simulation, plan);
    std::filesystem::remove_all(plan.folder);
    Outcome o;
    o.ok = r.ok();
    o.energy_drift = r.energy_drift;
    o.momentum_drift = r.momentum_drift;
    for (const auto& [name, value] : a.errors(plan.t_end)) o.error[name] = value;
    const auto facts = a.facts(plan.t_end);
    if (s.column.which == "A") o.u_end = facts[0].second;
    if (s.column.which == "C") o.kept_quarter = facts[0].second, o.kept = facts[1].second;
    return o;
}
template <class Kernel, class Law, class Transfer>
Outcome tlmpm(const Report& s, const Transfer& transfer, const std::string& stress = "musl") {
    return run_column<Kernel, Law>(s, Tlmpm{stress}, transfer);
}
template <class Kernel, class Transfer>
Outcome neo_hookean(const Report& s, const Transfer& transfer, const std::string& stress = "musl") {
    return tlmpm<Kernel, NeoHookean>(s, transfer, stress);
}
template <class Kernel>
Outcome hooke(const Report& s, const Flip& transfer) {
    return tlmpm<Kernel, Hooke>(s, transfer);
}
template <class Kernel>
Outcome neo_hookean_fem(Report s) {
    s.column.placing = "gauss";
    return run_column<Kernel, NeoHookean>(s, TotalFem{}, NoTransfer{});
}

// ---- exact solutions

/// P(F) of the report's equation 5 times F, written out: mu (F - 1/F) + lambda ln F/F.
double P_of(double F, double lambda, double mu) { return mu * (F - 1 / F) + lambda * std::log(F) / F; }
/// The stored energy of its equation 4.
double W_of(double F, double lambda, double mu) { return mu * (F * F - 1) / 2 - mu * std::log(F) + lambda * std::log(F) * std::log(F) / 2; }

TEST(ColumnAtRest, IsTheOneOfNumbersSection5) {
    const Column<NeoHookean> column(column_case("A"));
    const NeoHookean law = column.law();
    const auto rest = column.at_rest(law, column.tau(1.2));
    EXPECT_NEAR(rest.displacement(0.1), -0.058625, 5e-7);
    EXPECT_NEAR(rest.F(0.1), 0.413859, 5e-7);
    EXPECT_NEAR(rest.stress(0.01), -10008.83, 5e-3);
    EXPECT_DOUBLE_EQ(rest.stress(0.1), -1e4);
}
// Independently: with dP/dX = -rho b, int F dX = -1/(rho b) int F dP = -1/(rho b) [F P - W], in closed form.
TEST(ColumnAtRest, DisplacementIsThatOfTheComplementaryEnergy) {
    for (const double gravity : {-9.81, -2e4, 300.0}) {
        ColumnCase data = column_case("A");
        data.gravity = gravity;
        const Column<NeoHookean> column(data);
        const NeoHookean law = column.law();
        const auto rest = column.at_rest(law, -1e4);
        const double rho_b = data.rho * gravity, F0 = rest.F(0), FL = rest.F(data.length);
        EXPECT_NEAR(P_of(F0, law.lambda, law.mu), -1e4 + rho_b * data.length, 1e-8);
        const auto complementary = [&](double F) { return F * P_of(F, law.lambda, law.mu) - W_of(F, law.lambda, law.mu); };
        const double u = -(complementary(FL) - complementary(F0)) / rho_b - data.length;
        EXPECT_NEAR(rest.displacement(data.length) / u, 1, 1e-9) << gravity;  // the difference of two near values at small gravity
    }
}
TEST(ColumnAtRest, RefusesAStressThatTheLawCannotCarry) {
    EXPECT_THROW(stretch(Hooke{0, 1, 1}, -3.0), BadInput);  // F would be -1/2
    EXPECT_NEAR(stretch(Hooke{0, 1, 1}, -1.0), 0.5, 1e-15);
}

/// Equation 70 as printed, n terms.
double series(double X, double t, double L, double c, double strain, int n) {
    double sum = 0;
    for (int i = 1; i <= n; ++i) {
        const double k = (2 * i - 1) * pi / (2 * L);
        sum += (i % 2 == 1 ? 1 : -1) / std::pow(2 * i - 1, 2) * std::sin(k * X) * (1 - std::cos(k * c * t));
    }
    return 8 * strain * L / (pi * pi) * sum;
}
TEST(StepLoad, ClosedFormIsTheSeries) {
    const double L = 5, c = 359.4, strain = -5.08e-3;
    for (const double X : {0.0, 0.7, 2.5, 4.9, 5.0})
        for (const double t : {0.0, 0.003, 0.0139, 0.031, 0.0556, 0.2})
            EXPECT_NEAR(step_loaded(X, c * t, L, strain), series(X, t, L, c, strain, 20000), 2e-5 * std::abs(strain * L))
                << X << " " << t;  // tail 1/(pi^2 n)
}
TEST(StepLoad, SatisfiesItsConditions) {
    const double L = 5, strain = -5.08e-3;
    for (double X = 0; X <= L; X += L / 8) {
        EXPECT_EQ(step_loaded(X, 0, L, strain), 0);                                             // at rest,
        EXPECT_NEAR(step_loaded(X, 1e-3, L, strain), X > L - 1e-3 ? strain * 1e-3 : 0, 1e-15);  // and nothing moves before the wave comes
    }
    for (double ct = 0.01; ct < 6 * L; ct += 0.371) {
        EXPECT_NEAR(step_loaded(0, ct, L, strain), 0, 1e-15);                                                      // held
        EXPECT_NEAR((step_loaded(L, ct, L, strain) - step_loaded(L - 1e-4, ct, L, strain)) / 1e-4, strain, 1e-9);  // du/dX = tau/E
        EXPECT_NEAR(step_loaded(3, ct, L, strain), step_loaded(3, ct + 4 * L, L, strain), 1e-14);                  // period 4 L/c
    }
}

// ---- A: quasi-static compression

TEST(ColumnA, ReachesItsStaticState) {
    const Outcome o = neo_hookean<Hat>(Report("A"), Flip{0.5});
    EXPECT_NEAR(o.u_end, -0.058625, 1e-6);
    EXPECT_LT(o.error.at("u_static"), 1e-5);  // the midpoint rule of the bar at rest, and what is left of the ramp's vibration
    EXPECT_LT(o.error.at("sigma_static"), 1e-5);
}
TEST(ColumnA, ReportsPositionUpdateIsFivePercentOff) {
    const Outcome o = neo_hookean<Hat>(Report("A"), MovedByParticles{{0.5}});
    EXPECT_NEAR(o.error.at("u_static"), 0.050, 0.002);
    EXPECT_LT(o.error.at("sigma_static"), 1e-5);  // the strains know nothing of it
    // A wall's cell errs by a part of itself: order 1
    EXPECT_NEAR(neo_hookean<Hat>(Report("A").cells(20), MovedByParticles{{0.5}}).error.at("u_static") / o.error.at("u_static"), 0.5, 0.03);
}
TEST(ColumnA, DampingLeavesTheStaticStateAndClosesTheBalances) {
    const Report damped = Report("A").damping(0.2);
    for (const Outcome& o : {neo_hookean<Hat>(damped, Flip{}), neo_hookean<Lagrange2>(damped, Flip{}), neo_hookean_fem<Hat>(damped)}) {
        EXPECT_LT(o.error.at("u_static"), 1e-6);
        EXPECT_LT(std::abs(o.energy_drift), 1e-4);  // ripple of the leapfrog, relative to the work of the load
        EXPECT_LT(o.momentum_drift, 1e-9);          // rounding of impulses 1e6 times the momentum in play
    }
    // Without damping and with FLIP the vibration that the ramp excites goes on.
    EXPECT_GT(neo_hookean<Hat>(Report("A"), Flip{}).error.at("sigma_static"), 1e-3);
}
TEST(ColumnA, EndsWithFiniteElements) {
    const Report damped = Report("A").damping(0.2);
    EXPECT_NEAR(neo_hookean<Hat>(damped, Flip{0.5}).u_end / neo_hookean_fem<Hat>(damped).u_end, 1, 1e-7);
}

// ---- B: step load

TEST(ColumnB, ErrorsOfNumbersSection5FallWithOrderOne) {
    const std::vector<double> lagrange{4.8e-2, 2.5e-2, 1.3e-2, 6.6e-3, 3.4e-3};
    double before = 0;
    int cells = 8;
    for (const double expected : lagrange) {
        const double rms = hooke<Lagrange2>(Report("B").cells(cells), Flip{0.5}).error.at("u_end_rms");
        EXPECT_NEAR(rms / expected, 1, 0.04) << cells;  // the figures have two digits; at 8 cells they are 3 % below
        if (cells > 8) {
            EXPECT_NEAR(std::log2(before / rms), 0.97, 0.03) << cells;
        }
        before = rms;
        cells *= 2;
    }
    EXPECT_NEAR((hooke<Hat>(Report("B").cells(8), Flip{}).error.at("u_end_rms")), 1.0e-1, 6e-3);
    EXPECT_NEAR((hooke<Hat>(Report("B").cells(128), Flip{}).error.at("u_end_rms")), 6.5e-3, 1e-4);
}
TEST(ColumnB, BalancesClose) {
    const Outcome o = hooke<Hat>(Report("B"), Flip{});
    EXPECT_LT(std::abs(o.energy_drift), 1e-3);  // ripple w dt/2 of what vibrates
    EXPECT_LT(o.momentum_drift, 1e-13);
}
// With nu = 0, P = E/2 (F - 1/F) = E (e - e^2/2 + ...): c^2 is larger by -e, which is .005 in the mean. After 3.6 periods the triangle
// wave, whose slope is 4 |tau L/E| a period, is ahead by .9 % of a period: 4 x .009/sqrt(3) = .021 rms over time, on any grid.
TEST(ColumnB, NeoHookeanBarStaysTwoPercentFromTheLinearSeries) {
    const double coarse = neo_hookean<Hat>(Report("B").cells(64), Flip{}).error.at("u_end_rms");
    const double fine = neo_hookean<Hat>(Report("B").cells(128), Flip{}).error.at("u_end_rms");
    EXPECT_NEAR(fine, 2.1e-2, 1e-3);
    EXPECT_NEAR(fine / coarse, 1, 0.1);
    Report weak("B");  // a hundredth of the load: linear again
    weak.column.traction /= 100;
    EXPECT_NEAR((neo_hookean<Hat>(weak.cells(128), Flip{}).error.at("u_end_rms")), 6.5e-3, 2e-4);
}

// ---- C: energy

void expect_kept(const Outcome& o, double quarter, double end, double tolerance = 2e-3) {
    EXPECT_TRUE(o.ok);
    EXPECT_NEAR(o.kept_quarter, quarter, tolerance);
    EXPECT_NEAR(o.kept, end, tolerance);
}
TEST(ColumnC, EnergyOfNumbersSection5) {
    const Report s("C");
    expect_kept(neo_hookean<Lagrange2>(s, Flip{0.5}), 0.956, 0.929);
    expect_kept(neo_hookean<Lagrange2>(s, Flip{}), 1.003, 0.998);
    expect_kept(neo_hookean<Hat>(s, Flip{0.5}), 0.559, 0.179);
    expect_kept(neo_hookean<Hat>(s, Flip{}), 1.001, 0.996);
    expect_kept(neo_hookean<Hat>(s, Flip{}, "usl"), 0.963, 0.935);
    expect_kept(neo_hookean<Hat>(s, Flip{0}), 0.380, 0.039);
    expect_kept(neo_hookean<Hat>(s, Apic<true>{}), 0.984, 0.976);
}
TEST(ColumnC, EnergyOfNumbersSection5WithSeriesAndConsistentMass) {
    const Report s("C");
    expect_kept(neo_hookean<Hat>(s, Fmpm{2}), 0.936, 0.905);
    expect_kept(neo_hookean<Hat>(s, Fmpm{4}), 0.980, 0.969);
    expect_kept(neo_hookean<Hat>(s, Fmpm{8}), 0.989, 0.984);
    expect_kept(neo_hookean<Hat>(s, Fmpm{16}), 0.992, 0.988);
    Consistent<true> pic;
    pic.alpha = 0;
    expect_kept(neo_hookean<Hat>(s, pic), 0.993, 0.990);
    expect_kept(neo_hookean<Hat>(s, Consistent<true>{}), 1.002, 0.999);
}
// NUMBERS has .932, .897 and .954, .927. How the terms of the series are treated at the held node decides here: without zeroing them there
// (as this page does and NUMBERS section 9 asks) two terms keep .910, .847 and five terms with USL blow up.
TEST(ColumnC, EnergyOfXpic) {
    expect_kept(neo_hookean<Hat>(Report("C"), xpic(2)), 0.932, 0.897, 0.008);
    expect_kept(neo_hookean<Hat>(Report("C"), xpic(5)), 0.989, 0.973);
}
TEST(ColumnC, SmoothStartIsKeptByAllThatSeeIt) {
    const Report s = Report("C").start("smooth");
    expect_kept(neo_hookean<Hat>(s, Flip{}), 1, 0.9975);
    expect_kept(neo_hookean<Hat>(s, Apic<true>{}), 1, 0.9975);
    expect_kept(neo_hookean<Hat>(s, Fmpm{8}), 1, 0.9975);
    expect_kept(neo_hookean<Hat>(s, Consistent<true>{}), 1, 0.9975);
    EXPECT_LT((neo_hookean<Hat>(s, Flip{0.5}).kept), 0.5);
}
TEST(ColumnC, WallTakesAllTheMomentumThatIsMissing) {
    for (const char* stress : {"musl", "usl"}) EXPECT_LT(neo_hookean<Hat>(Report("C"), Flip{}, stress).momentum_drift, 1e-13) << stress;
}

// ---- the scene

TEST(Column, StartsWithItsEnergy) {
    for (const char* start : {"uniform", "smooth"}) {
        const Column<NeoHookean> column(Report("C").start(start).column);
        double energy = 0;
        for (const auto& p : column.particles<Point<1>>(32, 3)) energy += 0.5 * p.m * p.v.squaredNorm();
        EXPECT_NEAR(energy, 5e-5, 1e-17) << start;
    }
    EXPECT_NEAR(column_case("C").v0(), 1, 1e-15);
}
// The traction is put on the last node because every function is 1 there at the end of the grid, eq. 34 with X* = L.
template <class Kernel>
void expect_one_at_the_end() {
    const Tensor<1, Kernel> shape{Lattice<1>(Vec<1>(0.0), Vec<1>(0.1), {6}, Kernel::per_cell), sized<Kernel>(2)};
    for (const auto& [node, phi, grad] : shape.at(Vec<1>(0.6), Point<1>{}))
        EXPECT_NEAR(phi, node == shape.lattice.size() - 1 ? 1 : 0, 1e-14) << Kernel::name;
}
TEST(Column, EndOfTheGridBelongsToTheLastNode) {
    expect_one_at_the_end<Hat>();
    expect_one_at_the_end<Lagrange2>();
    expect_one_at_the_end<Ugimp>();
    expect_one_at_the_end<Cpgimp>();
    expect_one_at_the_end<Quadratic>();
    expect_one_at_the_end<Cubic>();
    expect_one_at_the_end<Bernstein>();
}
TEST(Column, RefusesWhatItsReferenceDoesNotKnow) {
    ColumnCase b = column_case("B"), c = column_case("C");
    EXPECT_NO_THROW(b.check());
    EXPECT_NO_THROW(c.check());
    b.gravity = 1;
    c.traction = 1;
    EXPECT_THROW(b.check(), BadInput);
    EXPECT_THROW(c.check(), BadInput);
    ColumnCase still = column_case("C");
    still.energy = 0;
    EXPECT_THROW(still.check(), BadInput);
}

}  // namespace
}  // namespace mpm::test
