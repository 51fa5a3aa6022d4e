// Fields smoothed through the grid, for the whole family of weighting functions.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "chapters/weighting/cubic.hpp"
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/quadratic.hpp"
#include "chapters/weighting/tensor.hpp"
#include "chapters/weighting/ugimp.hpp"
#include "lab/smooth.hpp"

namespace mpm {
namespace {

struct Dot {
    static constexpr int D = 2;
    Vec<2> x = Vec<2>::Zero();
    Mat<2> F = identity<2>();
    double m = 1;
};
constexpr int cells = 12, ppc = 2;

/// Particles in the middles of equal parts of every cell of a square, each moved by up to `jitter` of its part.
std::vector<Dot> square(double jitter) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(-0.5, 0.5);
    std::vector<Dot> all;
    for (int j = 0; j < cells * ppc; ++j)
        for (int i = 0; i < cells * ppc; ++i) {
            Dot& p = all.emplace_back();
            p.x = Vec<2>(i + 0.5 + jitter * part(random), j + 0.5 + jitter * part(random)) / ppc;
            if (jitter > 0) p.m = 1.5 + part(random);
        }
    return all;
}

template <class Kernel> class Smoothing : public testing::Test {
protected:
    static std::vector<double> smooth(const std::vector<Dot>& points, const std::vector<double>& field) {
        const Tensor<2, Kernel> shape{{Vec<2>(0, 0), Vec<2>(1, 1), {cells, cells}}, {}};
        std::vector<double> m;
        for (const Dot& p : points) m.push_back(p.m);
        return smoothed(mapping_of(shape, points), m, field);
    }
};
using Family = testing::Types<Hat, Ugimp, Quadratic, Cubic>;
TYPED_TEST_SUITE(Smoothing, Family);

TYPED_TEST(Smoothing, KeepsAConstantWhereverParticlesAre) {
    const auto points = square(0.9);
    for (const double value : this->smooth(points, std::vector<double>(points.size(), 3.7)))
        EXPECT_NEAR(value, 3.7, 1e-14 * 3.7 * 16);  // sums of at most 16 weights
}
TYPED_TEST(Smoothing, KeepsTheTotalOfEachComponent) {
    const auto points = square(0.9);
    std::mt19937 random(7);
    std::vector<double> field;
    for (std::size_t i = 0; i < 2 * points.size(); ++i) field.push_back(std::normal_distribution<double>(1, 1)(random));
    const auto smooth = this->smooth(points, field);
    for (const std::size_t c : {0, 1}) {
        double before = 0, after = 0;
        for (std::size_t p = 0; p < points.size(); ++p) before += points[p].m * field[2 * p + c], after += points[p].m * smooth[2 * p + c];
        EXPECT_NEAR(after, before, 1e-12 * std::abs(before) * std::sqrt(static_cast<double>(points.size())));  // rounding of the sums
    }
}
// In the interior: every node that a particle touches has its mirror images of particles around it. Smooth functions at the ends of the
// grid are folded, so stay away from these by the reach of the widest, twice.
TYPED_TEST(Smoothing, KeepsALinearFieldOfRegularParticles) {
    const auto points = square(0);
    const auto line = [](const Vec<2>& x) { return 2 - 3 * x[0] + 5 * x[1]; };
    std::vector<double> field;
    for (const Dot& p : points) field.push_back(line(p.x));
    const auto smooth = this->smooth(points, field);
    int inner = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if ((points[p].x - Vec<2>::Constant(cells / 2.0)).template lpNorm<Eigen::Infinity>() > cells / 2.0 - 4) continue;
        EXPECT_NEAR(smooth[p], field[p], 1e-12);  // values up to 62, rounding of 16 terms twice
        ++inner;
    }
    EXPECT_EQ(inner, 64);
}
// A chequerboard is what hat functions cannot see at all; the others weaken it too.
TYPED_TEST(Smoothing, TakesNoiseAway) {
    const auto points = square(0);
    std::mt19937 random(11);
    std::vector<double> noise;
    for (std::size_t i = 0; i < points.size(); ++i) noise.push_back(std::normal_distribution<double>()(random));
    const auto smooth = this->smooth(points, noise);
    const double before = std::inner_product(noise.begin(), noise.end(), noise.begin(), 0.0);
    const double after = std::inner_product(smooth.begin(), smooth.end(), smooth.begin(), 0.0);
    EXPECT_LT(after, before / 4);  // a node averages over about 2 x 2 particles or more
}

TEST(SmoothingHat, RemovesAChequerboard) {
    const auto points = square(0);
    std::vector<double> m(points.size(), 1.0), field;
    for (std::size_t p = 0; p < points.size(); ++p) field.push_back((p + p / (cells * ppc)) % 2 == 0 ? 1 : -1);
    const Tensor<2, Hat> shape{{Vec<2>(0, 0), Vec<2>(1, 1), {cells, cells}}, {}};
    const auto smooth = smoothed(mapping_of(shape, points), m, field);
    for (std::size_t p = 0; p < points.size(); ++p) {
        if ((points[p].x - Vec<2>::Constant(cells / 2.0)).lpNorm<Eigen::Infinity>() < cells / 2.0 - 1) {
            EXPECT_NEAR(smooth[p], 0, 1e-14);
        }
    }
}
TEST(SmoothingNothing, IsNothing) { EXPECT_TRUE(smoothed({}, {}, {}).empty()); }

}  // namespace
}  // namespace mpm
