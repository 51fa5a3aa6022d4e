// The scenes of implicit MPM: particles of appendix A, the vibrating and the flying bar, the resting column.
#include <gtest/gtest.h>

#include "chapters/scenes/cantilever.hpp"
#include "chapters/scenes/graded.hpp"
#include "chapters/scenes/rolling_disk.hpp"

namespace mpm {
namespace {

double area(const std::vector<Placed>& all) {
    double sum = 0;
    for (const Placed& p : all) sum += p.V;
    return sum;
}
TEST(Graded, DiskHasItsArea) {
    const auto disk = graded_disk(1.6, 1.4, 300, 22);
    EXPECT_EQ(disk.size(), 46978u);  // appendix A as printed
    EXPECT_NEAR(area(disk) / (std::numbers::pi * 1.6 * 1.6), 1, 1e-12);
    EXPECT_NEAR(disk.back().x.norm(), 1.6, 1e-15);
}
TEST(Graded, BeamHasItsArea) {
    const auto beam = graded_beam(0.625, 0.25, 0.15, 20, 20);
    EXPECT_EQ(beam.size(), 23040u);  // 23,041 in print, whose counter starts at 1
    EXPECT_NEAR(area(beam) / (0.625 * 0.25), 1, 1e-12);
    for (const Placed& p : beam) {
        EXPECT_GE(p.x[0], 0);
        EXPECT_LE(p.x[0], 0.625 + 1e-15);
        EXPECT_LE(std::abs(p.x[1]), 0.125 + 1e-15);
        EXPECT_GT(p.V, 0);
    }
}
TEST(Graded, LayersBecomeFiner) {
    EXPECT_NEAR(grading(1, 2, 0.75), 0.5, 1e-15);
    EXPECT_THROW(grading(1, 2, 2.5), BadInput);
}
TEST(RollingDisk, CellsAreRefinements) {
    EXPECT_EQ(RollingDisk::refinement(160), 3);
    EXPECT_THROW(RollingDisk::refinement(50), BadInput);
}
TEST(Cantilever, BeamTheory) {
    const Cantilever beam;
    EXPECT_NEAR(beam.slender_frequency(), 1.488, 1e-3);  // 3.516/(2 pi) sqrt(E' I/(rho A L^4)) by hand
    EXPECT_LT(beam.frequency(), beam.slender_frequency());
}

}  // namespace
}  // namespace mpm
