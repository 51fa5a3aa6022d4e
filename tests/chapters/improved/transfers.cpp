// The improved transfers: their limits, what they reproduce and conserve, and their closed-form frequencies.
#include "chapters/improved/transfers.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "chapters/material/hooke.hpp"
#include "chapters/scenes/bar.hpp"
#include "tests/chapters/explicit/problem.hpp"

namespace mpm::test {
namespace {

const NeoHookean soft{30, 20, 1};

template <class Scheme, class Transfer, class Kernel = Hat> auto square(const Transfer& transfer) {
    Problem<2, Scheme, NeoHookean, Kernel, Transfer> s;
    s.transfer = transfer;
    s.add(soft, 4, 2, 3, 10, 0.25);
    for (auto& p : s.points())
        p.v = Vec<2>(0.2 * std::sin(std::numbers::pi * p.X[0]), 0.1 * std::cos(std::numbers::pi * p.X[1]) + 0.05 * p.X[0]);
    return s;
}
template <class A, class B> double largest_difference(A& a, B& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.points().size(); ++i) largest = std::max(largest, (a.points()[i].v - b.points()[i].v).norm());
    return largest;
}

TEST(Limits, OneTermOfEitherSeriesIsPic) {
    auto pic = square<Tlmpm>(Flip{0});
    auto fmpm = square<Tlmpm>(Fmpm{1});
    auto xpic_1 = square<Tlmpm>(xpic(1));
    pic.run(20, 0.002);
    fmpm.run(20, 0.002);
    xpic_1.run(20, 0.002);
    EXPECT_LT(largest_difference(pic, fmpm), 1e-14);
    EXPECT_LT(largest_difference(pic, xpic_1), 1e-14);
}

TEST(Limits, ManyTermsAreTheConsistentMassMatrix) {
    Consistent<true> exact;
    exact.alpha = 0;
    auto consistent = square<Tlmpm>(exact);
    auto few = square<Tlmpm>(Fmpm{20}), many = square<Tlmpm>(Fmpm{400});
    consistent.run(1, 0.002);
    few.run(1, 0.002);
    many.run(1, 0.002);
    EXPECT_LT(largest_difference(consistent, many), 1e-10);  // (1 - r)^400 with the least eigenvalue r of S+ S about 0.06
    EXPECT_GT(largest_difference(consistent, few), 1e-8);
}

TEST(Limits, HeldNodesAgreeToo) {
    Consistent<true> exact;
    exact.alpha = 0;
    auto consistent = square<Tlmpm>(exact);
    auto many = square<Tlmpm>(Fmpm{400});
    consistent.held.hold_plane(consistent.lattice, 0, 0.75, true, 0, 0.3);
    many.held = consistent.held;
    consistent.run(1, 0.002);
    many.run(1, 0.002);
    EXPECT_LT(largest_difference(consistent, many), 1e-10);
}

template <class Scheme, class Transfer> struct Pair {
    using SchemeType = Scheme;
    using TransferType = Transfer;
};
template <class P> class Conserving : public testing::Test {};
using Pairs = testing::Types<Pair<Usl, Apic<false>>, Pair<Musl, Apic<false>>, Pair<Usf, Apic<false>>, Pair<Tlmpm, Apic<true>>,
                             Pair<Usl, Fmpm>, Pair<Musl, Fmpm>, Pair<Usf, Fmpm>, Pair<Tlmpm, Fmpm>, Pair<Usl, Consistent<false>>,
                             Pair<Musl, Consistent<false>>, Pair<Tlmpm, Consistent<true>>>;
TYPED_TEST_SUITE(Conserving, Pairs);

TYPED_TEST(Conserving, FreeSquareKeepsItsMomentum) {
    using Transfer = typename TypeParam::TransferType;
    // With smooth functions the consistent mass of nodes outside the body is that of cut cells, whose stable step is far smaller.
    using Kernel = std::conditional_t < requires { Transfer::alpha; }
    , Hat, Quadratic > ;
    auto s = square<typename TypeParam::SchemeType, Transfer, Kernel>({});
    const Vec<2> before = s.momentum();
    s.run(100, 0.002);
    EXPECT_LT((s.momentum() - before).norm(), 1e-12);  // the consistent solve adds rounding of its own
}

TEST(Xpic, FreeSquareKeepsItsMomentum) {
    auto s = square<Musl, Fmpm, Quadratic>(xpic(3));
    const Vec<2> before = s.momentum();
    s.run(100, 0.002);
    EXPECT_LT((s.momentum() - before).norm(), 1e-12);
}

// A velocity field that is linear in space, on a body without stress, is kept by one step of every transfer but PIC.
template <class Transfer, class Scheme, class Kernel> double change_of_linear_field(const Transfer& transfer) {
    Problem<2, Scheme, NeoHookean, Kernel, Transfer> s;
    s.transfer = transfer;
    s.add(soft, 4, 2, 3, 10, 0.25);
    const auto field = [](const Vec<2>& x) { return Vec<2>(0.1 + 0.3 * x[0] - 0.2 * x[1], 0.5 * x[0] + 0.1 * x[1]); };
    for (auto& p : s.points()) {
        p.v = field(p.x);
        if constexpr (requires { p.C; }) p.C << 0.3, -0.2, 0.5, 0.1;
    }
    s.run(1, 1e-9);
    double largest = 0;
    for (const auto& p : s.points()) largest = std::max(largest, (p.v - field(p.X)).norm());
    return largest;
}
TEST(LinearField, ApicKeepsIt) {
    EXPECT_LT((change_of_linear_field<Apic<true>, Tlmpm, Hat>({})), 1e-8);  // stress of the first step: dt^2 times the modulus over h
    EXPECT_LT((change_of_linear_field<Apic<true>, Tlmpm, Cubic>({})), 1e-8);
    EXPECT_LT((change_of_linear_field<Apic<false>, Usl, Quadratic>({})), 1e-8);
}
TEST(LinearField, ConsistentMassKeepsIt) {
    Consistent<true> pic;
    pic.alpha = 0;
    EXPECT_LT((change_of_linear_field<Consistent<true>, Tlmpm, Hat>(pic)), 1e-8);
}
TEST(LinearField, PicSmearsIt) { EXPECT_GT((change_of_linear_field<Flip, Tlmpm, Hat>(Flip{0})), 1e-3); }

// Angular momentum of particles and their affine fields, sum m (x cross v) + m C : D, is kept by mapping to the grid and back.
TEST(AngularMomentum, ApicKeepsItPicDoesNot) {
    const auto spin = [](const auto& points, double spread) {
        double sum = 0;
        for (const auto& p : points) {
            sum += p.m * (p.x[0] * p.v[1] - p.x[1] * p.v[0]);
            if constexpr (requires { p.C; }) sum += p.m * spread * (p.C(1, 0) - p.C(0, 1));
        }
        return sum;
    };
    const double h = 0.25, spread = h * h / 4;  // sum phi (x_I - x_p)^2 of quadratic B-splines
    const auto change = [&](auto transfer) {
        Problem<2, Usl, NeoHookean, Quadratic, decltype(transfer)> s;
        s.transfer = transfer;
        s.add(soft, 4, 2, 3, 10, h);
        for (auto& p : s.points()) p.v = Vec<2>(-(p.x[1] - 1.25), p.x[0] - 1.25) + 0.1 * Vec<2>(std::sin(9 * p.x[1]), std::cos(7 * p.x[0]));
        const double before = spin(s.points(), spread);
        s.run(1, 1e-9);
        return std::abs(spin(s.points(), spread) / before - 1);
    };
    EXPECT_LT(change(Apic<false>{}), 1e-8);
    EXPECT_GT(change(Flip{0}), 1e-2);
}

// Frequencies of the total-Lagrangian bar: w_h, then the leapfrog w = 2/dt asin(w_h dt/2). NUMBERS: 5e-5 is the error of interpolated
// zeros.
template <class Transfer> double frequency(int ppc, int mode, const Transfer& transfer) {
    Bar<true> bar;
    bar.mode = mode;
    Problem<1, Tlmpm, Hooke, Hat, Transfer> s;
    s.transfer = transfer;
    s.lattice = bar.lattice(16, 1);
    s.add_points(bar.law(), bar.particles<typename decltype(s)::Point>(16, ppc), ppc);
    s.held.held = {{0, 0, 0}};
    Bar<true>::Observer observer{bar};
    const double dt = 0.1 * bar.cell_size(16) / 10;
    for (int k = 1; k <= static_cast<int>(40 / dt); ++k) {
        s.run(1, dt);
        observer.sample(s.points(), k * dt, std::nan(""));
    }
    return observer.wave.omega();
}
TEST(ClosedForm, ApicHasTheFrequencyOfLumpedFiniteElements) {
    for (const int mode : {1, 2, 3}) {
        const double h = 25.0 / 16, beta = (2 * mode - 1) * std::numbers::pi / 50, dt = 0.1 * h / 10, w_h = 20 / h * std::sin(beta * h / 2);
        EXPECT_NEAR(frequency(1, mode, Apic<true>{}) / (2 / dt * std::asin(w_h * dt / 2)), 1,
                    5e-4);  // APIC damps the start: a few 1e-4 of mode 3
    }
}
TEST(ClosedForm, ConsistentMassWithTwoParticlesPerCell) {
    for (const int mode : {1, 2, 3}) {
        const double h = 25.0 / 16, beta = (2 * mode - 1) * std::numbers::pi / 50, dt = 0.1 * h / 10;
        const double w_h = 20 / h * std::sin(beta * h / 2) / std::sqrt(1 - 0.375 * (1 - std::cos(beta * h)));
        EXPECT_NEAR(frequency(2, mode, Consistent<true>{}) / (2 / dt * std::asin(w_h * dt / 2)), 1, 5e-5);
    }
}

TEST(Choice, RefusesWhatCannotWork) {
    const auto message = [](std::vector<const char*> words) {
        Options o("p", "");
        TransferChoice choice;
        choice.declare(o);
        words.insert(words.begin(), "p");
        o.parse(static_cast<int>(words.size()), words.data());
        try {
            choice.check(1);
        } catch (const BadInput& bad) {
            return std::string(bad.what());
        }
        return std::string();
    };
    EXPECT_EQ(message({"--transfer", "fmpm", "--order", "4"}), "");
    EXPECT_NE(message({"--transfer", "apic", "--order", "4"}).find("--order"), std::string::npos);
    EXPECT_NE(message({"--transfer", "fmpm", "--alpha", "0.5"}).find("--alpha"), std::string::npos);
    EXPECT_NE(message({"--transfer", "consistent"}).find("singular"), std::string::npos);
}

}  // namespace
}  // namespace mpm::test
