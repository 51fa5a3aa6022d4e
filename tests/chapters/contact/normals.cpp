#include "chapters/contact/grid_normals.hpp"

#include <gtest/gtest.h>

namespace mpm::test {
namespace {

std::vector<CloudPoint<2>> rows(double angle, double from, double to, int first, int last, double spacing) {
    static const Mat<2> F = identity<2>();
    const Vec<2> along(std::cos(angle), std::sin(angle)), up(-along[1], along[0]);
    std::vector<CloudPoint<2>> cloud;
    for (int j = first; j <= last; ++j)
        for (double s = from; s <= to; s += spacing) cloud.push_back({s * along + (j + 0.5) * spacing * up, spacing / 2, &F});
    return cloud;
}

// Flat faces at any angle, also where one cloud is a corner that stands out on one side alone. The penalty leans the plane
// towards the clouds' middles: by less than a degree.
TEST(Regression, FindsTheNormalOfFlatFaces) {
    for (const double angle : {0.0, 0.3, 0.785, 2.0}) {
        const Vec<2> n(-std::sin(angle), std::cos(angle));
        const auto slab = rows(angle, -1, 1, -2, -1, 0.5), block = rows(angle, -1, 1, 0, 1, 0.5), corner = rows(angle, 0, 1, 0, 1, 0.5);
        EXPECT_LT(NodeNormals::angle(parting_normal<2>(slab, block, Vec<2>(1, 1)), n), 0.1);
        EXPECT_LT(NodeNormals::angle(parting_normal<2>(slab, corner, Vec<2>(1, 1)), n), 1);
        EXPECT_LT(NodeNormals::angle(parting_normal<2>(corner, slab, Vec<2>(1, 1)), Vec<2>(-n)), 1);
    }
}
// What is symmetric leaves no doubt: one particle above a row.
TEST(Regression, OfOneParticleAboveARow) {
    const auto slab = rows(0, -1, 1, -1, -1, 0.5);
    static const Mat<2> F = identity<2>();
    const std::vector<CloudPoint<2>> one{{Vec<2>(0, 0.25), 0.25, &F}};
    EXPECT_LT(NodeNormals::angle(parting_normal<2>(slab, one, Vec<2>(1, 1)), Vec<2>(0, 1)), 1e-6);
}
// Two clouds at one place have no normal, or any: it must be a unit vector or zero, never nan.
TEST(Regression, OfCoincidingCloudsIsDefined) {
    const auto slab = rows(0, -1, 1, -1, 0, 0.5);
    const Vec<2> n = parting_normal<2>(slab, slab, Vec<2>(1, 1));
    EXPECT_TRUE(n.allFinite());
    EXPECT_TRUE(n.norm() < 1e-12 || std::abs(n.norm() - 1) < 1e-12);
}
TEST(Extent, OfADeformedParticle) {
    const Mat<2> F{{2, 0}, {0, 0.5}};
    const CloudPoint<2> p{Vec<2>::Zero(), 0.1, &F};
    EXPECT_NEAR(p.extent({1, 0}), 0.2, 1e-15);
    EXPECT_NEAR(p.extent({0, 1}), 0.05, 1e-15);
}

// Review figure 46: the smooth kernel of the cells' density gives better normals around a disk than the hat functions' gradient, against
// remark 32, by which both are the same.
TEST(GridNormals, OfCellDensityAreBetterThanThoseOfTheGradient) {
    const NormalsSettings s;
    const MeanMost gradient = over(normals_around(s, "gradient"), &NodeNormals::error_common);
    const MeanMost density = over(normals_around(s, "density"), &NodeNormals::error_common);
    EXPECT_LT(density.mean, 0.5 * gradient.mean);
    EXPECT_LT(density.most, 0.5 * gradient.most);
}
// Review figure 47b, NUMBERS section 14: beside a slab the printed normals are 10 to 37 degrees from one line.
TEST(GridNormals, AsPrintedAreNotCollinear) {
    NormalsSettings s;
    s.beside = "slab";
    const MeanMost printed = over(normals_around(s, "gradient"), &NodeNormals::non_collinear);
    EXPECT_GT(printed.most, 10);
    EXPECT_LT(over(normals_around(s, "regression"), &NodeNormals::non_collinear).most, 1e-12);
}

}  // namespace
}  // namespace mpm::test
