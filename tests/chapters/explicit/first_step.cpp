// The first step from an undeformed state: there total-Lagrangian and updated-Lagrangian schemes are one.
#include "tests/chapters/explicit/one_step.hpp"

namespace mpm::test {
namespace {

/// A square with a rough velocity field after its first step.
template <class Scheme>
auto first_step(const Scheme& scheme) {
    Problem<2, Scheme, Probe> s;
    s.scheme = scheme;
    s.add({}, 3, 2, 1, 5, 0.5);
    for (auto& p : s.points()) {
        p.v = Vec<2>(std::sin(7 * p.X[0] + p.X[1]), std::cos(5 * p.X[1]));
        p.sigma << p.X[0], 0.5, 0.5, -p.X[1];
    }
    s.run(1, 0.01);
    return s.points();
}
TEST(FirstStep, OfTlmpmIsThatOfItsFlavour) {
    const auto musl = first_step(Musl{}), usl = first_step(Usl{}), total_musl = first_step(Tlmpm{}), total_usl = first_step(Tlmpm{"usl"});
    for (std::size_t i = 0; i < musl.size(); ++i) {
        expect_equal(total_musl[i].F, musl[i].F);
        expect_equal(total_usl[i].F, usl[i].F);
        expect_equal(total_musl[i].v, musl[i].v);
        expect_equal(total_usl[i].v, usl[i].v);
        expect_equal(total_usl[i].x, usl[i].x);
    }
    EXPECT_GT((musl[0].F - usl[0].F).norm(), 1e-5);
}
TEST(FirstStep, OfMuslMovesParticlesAsUsl) {
    const auto musl = first_step(Musl{}), usl = first_step(Usl{});
    for (std::size_t i = 0; i < musl.size(); ++i) {
        expect_equal(musl[i].v, usl[i].v);
        expect_equal(musl[i].x, usl[i].x);
    }
}

}  // namespace
}  // namespace mpm::test
