// What particles tell in a snapshot, with made-up points and laws.
#include "lab/columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/traits.hpp"

namespace mpm {
namespace {

template <int Dim> struct Dot {
    static constexpr int D = Dim;
    double m = 1, V0 = 2, V = 1;
    Vec<D> X = Vec<D>::Zero(), x = Vec<D>::Zero(), v = Vec<D>::Constant(3);
    Mat<D> F = identity<D>(), sigma = Mat<D>::Zero();
};
struct Dash {
    double m = 0;
    Vec<2> mv_new = Vec<2>::Zero();
    void reset() {}
};
struct Plain {};
struct Across {
    template <class Point> double sigma_zz(const Point&) const { return 7; }
};
/// With a history, columns of its own, and a material of each particle.
struct Ductile {
    template <class Base> struct PointOf : Base {
        double plastic = 0.25;
        int material = 2;
    };
    static constexpr std::array<const char*, 2> columns{"plastic_strain", "hardening"};
    template <class Point> std::array<double, 2> values(const Point& p) const { return {p.plastic, 4 * p.plastic}; }
};
template <int D, class Law> using Filled = Matter<D, typename WithHistory<Law, Dot<D>>::Point, Dash, Law>;

/// One particle with sxx = 5, syy = 1, sxy = 2.
template <class Law> Snapshot one_particle() {
    Filled<2, Law> body;
    body.points.resize(1);
    body.points[0].sigma << 5, 2, 2, 1;
    return particles_of<2>(std::vector<Filled<2, Law>*>{&body});
}
double value(const Snapshot& s, const std::string& column) { return s.at(0, s.find(column)); }

TEST(Columns, TakeTheMeanAcrossThePlaneIfTheLawDoesNotTell) {
    const Snapshot s = one_particle<Plain>();
    EXPECT_EQ(s.find("szz"), s.columns.size());
    EXPECT_DOUBLE_EQ(value(s, "pressure"), -3);
    EXPECT_DOUBLE_EQ(value(s, "mises"), std::sqrt(3.0 * (2 * 2 + 2 * 2)));  // deviator (2, -2, 0), shear 2: 3/2 (4 + 4 + 2 4)
    EXPECT_DOUBLE_EQ(value(s, "speed"), 3 * std::sqrt(2));
    EXPECT_DOUBLE_EQ(value(s, "J"), 0.5);
}
TEST(Columns, HoldTheStressAcrossThePlaneIfTheLawTellsIt) {
    const Snapshot s = one_particle<Across>();
    EXPECT_EQ(value(s, "szz"), 7);
    EXPECT_DOUBLE_EQ(value(s, "pressure"), -13.0 / 3);
    EXPECT_DOUBLE_EQ(value(s, "mises"), std::sqrt((16 + 36 + 4) / 2.0 + 12));
}
TEST(Columns, HoldTheLawsOwnAndTheMaterial) {
    const Snapshot s = one_particle<Ductile>();
    EXPECT_EQ(value(s, "material"), 2);
    EXPECT_EQ(value(s, "plastic_strain"), 0.25);
    EXPECT_EQ(value(s, "hardening"), 1);
    EXPECT_EQ(s.values.size(), s.columns.size());
}
TEST(Columns, OfALineAreFewer) {
    Matter<1, Dot<1>, Dash, Plain> body;
    body.points.resize(2);
    const Snapshot s = particles_of<1>(std::vector<Matter<1, Dot<1>, Dash, Plain>*>{&body, &body});
    EXPECT_EQ(s.columns, (std::vector<std::string>{"body", "x", "v", "F", "sigma", "V"}));
    EXPECT_EQ(s.rows(), 4u);
    EXPECT_EQ(s.at(3, 0), 1) << "the second body";
}
TEST(Columns, OfSmoothedStressAreNoNumbersOutsideTheGrid) {
    Filled<2, Plain> body;
    body.points.resize(1);
    const auto outside = [](std::size_t) -> Mapping { throw OutsideGrid("far away"); };
    const Snapshot s = particles_of<2>(std::vector<Filled<2, Plain>*>{&body}, outside);
    EXPECT_TRUE(std::isnan(value(s, "mises_smooth")));
    EXPECT_EQ(s.values.size(), s.columns.size());
}
TEST(Columns, AreWhatColoursMayBe) {
    const std::vector<std::string> all = colours<2, Ductile>();
    for (const char* name : {"body", "vx", "mises", "speed", "material", "hardening", "pressure_smooth"})
        EXPECT_NE(std::find(all.begin(), all.end(), name), all.end()) << name;
    EXPECT_EQ(std::find(all.begin(), all.end(), "szz"), all.end());
    EXPECT_TRUE((colours<1, Ductile>().empty()));
}

struct Resting {
    static constexpr int D = 2;
    using Law = Plain;
};
struct Swinging : Resting {
    double period() const { return 1; }
    Animated animated() const { return {"x", "y", "speed", "x", "y", "speed"}; }
};
TEST(Traits, AreReadOffAScene) {
    EXPECT_FALSE(traits_of(Resting{}).period);
    EXPECT_EQ(traits_of(Resting{}).colour, "mises");
    EXPECT_TRUE(traits_of(Swinging{}).period);
    EXPECT_EQ(traits_of(Swinging{}).colour, "speed");
}

}  // namespace
}  // namespace mpm
