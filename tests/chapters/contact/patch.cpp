// A bonded interface: the bodies have one velocity on every shared node, so they move as the whole block does, in every scheme.
#include <algorithm>

#include "chapters/contact/bardenhagen.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/usf.hpp"
#include "chapters/explicit/usl.hpp"
#include "tests/chapters/contact/pieces.hpp"

namespace mpm::test {
namespace {

template <class Scheme> class Patch : public testing::Test {};
using Schemes = testing::Types<Usl, Usf, Musl>;
TYPED_TEST_SUITE(Patch, Schemes);

TYPED_TEST(Patch, OfBondedBlocksIsTheWholeBlock) {
    Pieces<TypeParam> whole, parts;
    whole.add({0.6, 0.6}, {1, 1.2}, {0, 0});
    parts.add({0.6, 0.6}, {1, 0.95}, {0, 0});  // the cut runs through cells
    parts.add({0.6, 0.95}, {1, 1.2}, {0, 0});
    const auto stir = [](auto& s) {
        for (auto& body : s.bodies)
            for (auto& p : body.points) p.v = Vec<2>(p.X[1] * p.X[1], -0.5 * p.X[0]);
    };
    stir(whole), stir(parts);
    Free none;
    whole.run(none, 100, 1e-3);
    ContactChoice bonded;
    bonded.contact = "bonded";
    Bardenhagen<2> contact(bonded);
    parts.run(contact, 100, 1e-3);
    const auto& points = whole.bodies[0].points;
    for (const auto& body : parts.bodies)
        for (const auto& p : body.points) {
            const auto& q = *std::find_if(points.begin(), points.end(), [&](const auto& one) { return one.X == p.X; });
            EXPECT_LT((p.x - q.x).norm(), 1e-12);  // 1e-10 is required; sums are rounded in another order
            EXPECT_LT((p.v - q.v).norm(), 1e-10);
            EXPECT_LT((p.F - q.F).norm(), 1e-11);
        }
}

// MUSL treats contact in both mappings: after the second one bodies do not strain as if they went through each other.
TEST(Musl, TreatsContactInBothMappings) {
    Pieces<Musl> s;
    s.add({0.6, 0.6}, {1, 1}, {1, 0});
    s.add({1, 0.6}, {1.4, 1}, {-1, 0});
    Bardenhagen<2> contact(choice("regression", "on", "extent", 0));
    s.run(contact, 3, 1e-3);
    const int I = 8 * 21 + 10;  // (1, 0.8)
    EXPECT_NEAR(s.bodies[0].grid[I].v_new[0], s.bodies[1].grid[I].v_new[0], 1e-12);
}

}  // namespace
}  // namespace mpm::test
