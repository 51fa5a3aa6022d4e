// The norms of review A.2 and (6.7) on errors that are known.
#include "chapters/mms/norms.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace mpm::test {
namespace {

struct Moved {
    Vec<2> X = Vec<2>::Zero(), x = Vec<2>::Zero();
    double V = 1;
};
/// `n` particles off their exact displacement (3, 4) by `error` along y.
std::vector<Moved> off_by(double error, int n) {
    std::vector<Moved> points(static_cast<std::size_t>(n));
    for (auto& p : points) p.x = p.X + Vec<2>(3, 4 + error);
    return points;
}
void sample(DisplacementError& norms, const std::vector<Moved>& points) {
    norms.sample(points, [](const Moved&) { return Vec<2>(3, 4); }, [](const Moved& p) { return p.V; });
}

TEST(Norms, OfAConstantErrorAreThatErrorHoweverFineTheGridAndTheSteps) {
    for (const int n : {1, 10, 1000})
        for (const int steps : {1, 100}) {
            DisplacementError norms;
            for (int k = 0; k < steps; ++k) sample(norms, off_by(0.25, n));
            EXPECT_NEAR(norms.e1(), 0.25, 1e-14);
            EXPECT_NEAR(norms.e2(), 0.25 / 5, 1e-14);
            EXPECT_NEAR(norms.rmse(), 0.25, 1e-14) << "against the review: (6.7) does not shrink by itself";
        }
}

/// e1 is the largest in time; (6.7) hides what is large in the last hundredth of the run behind the root of that part.
TEST(Norms, OfALateErrorDiffer) {
    DisplacementError norms;
    for (int k = 0; k < 100; ++k) sample(norms, off_by(k < 99 ? 0 : 0.5, 7));
    EXPECT_NEAR(norms.e1(), 0.5, 1e-15);
    EXPECT_NEAR(norms.e2(), 0.5 / 5 / 10, 1e-15);
    EXPECT_NEAR(norms.rmse(), 0.5 / 10, 1e-15);
}

TEST(Norms, WeighByVolumeWhereTheReviewDoes) {
    auto points = off_by(0, 2);
    points[0].x[0] += 1;
    points[0].V = 3;
    DisplacementError norms;
    sample(norms, points);
    EXPECT_NEAR(norms.e1(), std::sqrt(3.0 / 4), 1e-15);
    EXPECT_NEAR(norms.e2(), std::sqrt(3.0 / 100), 1e-15);
    EXPECT_NEAR(norms.rmse(), std::sqrt(1.0 / 2), 1e-15);
}

TEST(Norms, OnceNotANumberStaySo) {
    DisplacementError norms;
    for (const double error : {1.0, std::numeric_limits<double>::quiet_NaN(), 2.0}) sample(norms, off_by(error, 3));
    EXPECT_TRUE(std::isnan(norms.e1()));
    EXPECT_TRUE(std::isnan(norms.e2()));
    EXPECT_TRUE(std::isnan(norms.rmse()));
}

}  // namespace
}  // namespace mpm::test
