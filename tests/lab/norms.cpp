#include "lab/norms.hpp"

#include <gtest/gtest.h>

namespace mpm {
namespace {

TEST(Oscillation, FindsTheFrequencyOfACosine) {
    Oscillation wave;
    for (int k = 0; k <= 10000; ++k) wave.sample(k * 0.01, std::cos(3 * k * 0.01), 0, 1);
    EXPECT_NEAR(wave.omega(), 3, 1e-5);  // linear interpolation of zeros: error of order dt^3 over 95 half periods
}
TEST(Oscillation, HasNoFrequencyWithoutCrossings) {
    Oscillation wave;
    for (int k = 0; k < 10; ++k) wave.sample(k, 1, 1, 1);
    EXPECT_TRUE(std::isnan(wave.omega()));
}
TEST(Oscillation, MeasuresRelativeL2) {
    Oscillation wave;
    for (int k = 0; k < 10; ++k) wave.sample(k, 1.1, 1, 1);
    EXPECT_NEAR(wave.relative_l2(), 0.1, 1e-14);
}
TEST(Oscillation, ComparesTheEnergyOfTheLastPeriodWithTheFirst) {
    Oscillation wave;
    for (int k = 0; k <= 100; ++k) wave.sample(k, 0, 1, k <= 10 ? 2 : 1);
    EXPECT_NEAR(wave.energy_kept(10, 100), 0.5, 1e-14);
}
TEST(Order, OfAQuarteredErrorIsTwo) { EXPECT_NEAR(observed_order(4e-3, 0.2, 1e-3, 0.1), 2, 1e-14); }

}  // namespace
}  // namespace mpm
