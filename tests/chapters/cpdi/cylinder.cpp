// The pressed cylinder: Lame's solution by itself, and coarse runs against it (review 3.6, 4.2.3; NUMBERS section 20). Fine ones:
// programs.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "chapters/cpdi/cylinder.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/usl.hpp"
#include "lab/norms.hpp"

namespace mpm::test {
namespace {

// Stresses by Hooke's law from the displacement, by differences; equilibrium d(r sigma_r)/dr = sigma_theta; -p inside and 0 outside.
TEST(Lame, IsInBalanceAndBelongsToItsDisplacement) {
    CylinderCase c;
    c.a = 0.4, c.b = 1.3, c.p = 2, c.E = 70, c.nu = 0.2;
    constexpr double d = 1e-5;
    for (const double r : {0.4, 0.7, 1.0, 1.3}) {
        const double e_r = (c.displacement(r + d) - c.displacement(r - d)) / (2 * d), e_t = c.displacement(r) / r;
        EXPECT_NEAR(c.radial(r), c.lambda() * (e_r + e_t) + 2 * c.mu() * e_r, 1e-7);  // d^2 of a central difference
        EXPECT_NEAR(c.hoop(r), c.lambda() * (e_r + e_t) + 2 * c.mu() * e_t, 1e-7);
        EXPECT_NEAR(((r + d) * c.radial(r + d) - (r - d) * c.radial(r - d)) / (2 * d), c.hoop(r), 1e-7);
    }
    EXPECT_NEAR(c.radial(c.a), -c.p, 1e-14);
    EXPECT_NEAR(c.radial(c.b), 0, 1e-14);
}

struct Rest {
    double displacement, hoop, momentum, u_mean;
};
Rest come_to_rest(const CylinderCase& cylinder, const char* shape, int cells) {
    Common common;
    common.shape = shape;
    common.ppc = 2;
    const Assembled a = assemble_domains<false>(Usl{}, PressedCylinder(cylinder), Flip{}, cells, common);
    const Simulation& s = a.simulation;
    const int steps = static_cast<int>(std::ceil(cylinder.time_to_rest() / (0.5 * a.critical_dt)));
    const double dt = cylinder.time_to_rest() / steps;
    std::array<double, 2> impulse{};
    double in_play = 0;
    for (int k = 0; k < steps; ++k) {
        s.step(k * dt, dt);
        const Supply supply = s.supply(k * dt, dt);
        for (const std::size_t d : {0, 1}) impulse[d] += supply.impulse[d];
        in_play = std::max(in_play, s.measure().momentum_in_play);
    }
    s.sample(cylinder.time_to_rest(), 0);
    const auto errors = a.errors(cylinder.time_to_rest());
    const Measures last = s.measure();
    const double lost = std::hypot(last.momentum[0] - impulse[0], last.momentum[1] - impulse[1]);
    return {errors[0].value, errors[1].value, lost / in_play, s.watch(0)[0]};
}

// 10 and 20 cells; the errors themselves are NUMBERS' within a quarter: the mesh there is not told.
TEST(PressedCylinder, ApproachesLameBySecondOrder) {
    for (const char* shape : {DomainQ4::name, DomainT3::name}) {
        const Rest coarse = come_to_rest({}, shape, 10), fine = come_to_rest({}, shape, 20);
        EXPECT_GT(observed_order(coarse.displacement, 0.1, fine.displacement, 0.05), 1.9) << shape;
        EXPECT_GT(observed_order(coarse.hoop, 0.1, fine.hoop, 0.05), 0.9) << shape;  // means over domains against values: first order
        EXPECT_NEAR(fine.displacement, shape == DomainQ4::name ? 5.3e-4 : 1.6e-3, shape == DomainQ4::name ? 1.3e-4 : 4e-4) << shape;
    }
}

// What edges, planes of symmetry and damping give is what the particles have.
TEST(PressedCylinder, AccountsForMomentum) {
    for (const char* load : {"dead", "follower"}) {
        CylinderCase cylinder;
        cylinder.load_kind = load;
        EXPECT_LT(come_to_rest(cylinder, DomainQ4::name, 8).momentum, 1e-12) << load;
    }
}

// Of small displacements neither law nor load matters. Of large ones a follower grows with the hole and widens it more.
TEST(PressedCylinder, FollowsItsBoundary) {
    CylinderCase hooke, dead, wide;
    hooke.law = Hooke::name;
    dead.load_kind = "dead";
    const double u = come_to_rest({}, DomainQ4::name, 8).u_mean;
    EXPECT_NEAR(come_to_rest(hooke, DomainQ4::name, 8).u_mean / u, 1, 1e-5);  // strains are 3e-6
    EXPECT_NEAR(come_to_rest(dead, DomainQ4::name, 8).u_mean / u, 1, 1e-5);
    wide.p = 100;
    const double follower = come_to_rest(wide, DomainQ4::name, 8).u_mean;
    wide.load_kind = "dead";
    EXPECT_GT(follower, 1.1 * come_to_rest(wide, DomainQ4::name, 8).u_mean);
}

}  // namespace
}  // namespace mpm::test
