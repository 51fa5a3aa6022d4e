// Plastic work heats a sheared block (review B.13).
#include <gtest/gtest.h>

#include "chapters/scenes/sheared_block.hpp"
#include "tests/chapters/thermal/hot_run.hpp"

namespace mpm::test {
namespace {

// The exact temperature leaves out the square of the elastic shear, 5e-6, and the explicit work its step in the elastic range, 1e-3 of
// that.
TEST(PlasticHeating, HeatsTheShearedBlock) {
    for (const double H : {0.0, 500e6}) {
        ShearSettings s;
        s.H = H;
        const Ran r = ran(ShearedBlock(s, 2e-5), 2, 0.2);
        EXPECT_LT(r.errors.at("temperature"), 2e-4) << H;
        EXPECT_LT(r.errors.at("work"), 2e-4) << H;
        EXPECT_LT(r.errors.at("heat"), 1e-12) << H;
        EXPECT_LT(r.particles.find("eps_p"), r.particles.find("T"));
        EXPECT_LT(r.particles.find("T"), r.particles.columns.size());
    }
}

}  // namespace
}  // namespace mpm::test
