// The area that polygons cover together.
#include "lab/covered_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace mpm {
namespace {

using Polygon = std::vector<Vec<2>>;
using Polygons = std::vector<Polygon>;

Polygon rectangle(double x, double y, double wide, double high) { return {{x, y}, {x + wide, y}, {x + wide, y + high}, {x, y + high}}; }
/// Rows of unit squares, each of which reaches 0.25 over its right neighbour, crossed by a long thin bar.
Polygons overlapping_rows(int rows) {
    Polygons all;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < rows; ++i) all.push_back(rectangle(i, j, i + 1 < rows ? 1.25 : 1, 1));
    all.push_back(rectangle(-1, 0.3, rows + 2.0, 0.125));
    return all;
}

TEST(CoveredArea, CountsOverlapsOnce) {
    EXPECT_DOUBLE_EQ(covered_area({rectangle(0, 0, 2, 1), rectangle(1, 0, 2, 1)}), 3);
    EXPECT_DOUBLE_EQ(covered_area({rectangle(0, 0, 3, 3), rectangle(1, 1, 1, 1)}), 9);
    EXPECT_DOUBLE_EQ(covered_area({rectangle(0, 0, 1, 1), rectangle(0, 50, 1, 1)}), 2);
    EXPECT_EQ(covered_area({}), 0);
    EXPECT_EQ(covered_area({{}, {{1, 1}}}), 0);
}
TEST(CoveredArea, KnowsHollows) {
    EXPECT_DOUBLE_EQ(covered_area({{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}}), 10);  // a notch of 6
}
TEST(CoveredArea, OfManyIsThatOfAllHoweverTheyAreTurned) {
    const double exact = 400 + 2 * 0.125;  // the bar's ends stand out
    for (const double angle : {0.0, 0.1, 0.7, 1.5707963267948966, 3.0}) {
        Polygons turned = overlapping_rows(20);
        const double c = std::cos(angle), s = std::sin(angle);
        for (Polygon& polygon : turned)
            for (Vec<2>& p : polygon) p = Vec<2>(c * p[0] - s * p[1], s * p[0] + c * p[1]);
        EXPECT_NEAR(covered_area(turned), exact, 1e-10) << angle;  // rounding of 1e4 slabs
    }
}

}  // namespace
}  // namespace mpm
