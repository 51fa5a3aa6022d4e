// The watch over domains names what is wrong with each kind, and leaves good ones alone.
#include "chapters/cpdi/watch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "chapters/cpdi/domains.hpp"
#include "chapters/cpdi/q4.hpp"
#include "chapters/explicit/point.hpp"

namespace mpm::test {
namespace {

using Corners2 = std::vector<Vec<2>>;
const Vec<2> h(1, 1);
std::string fault(const Corners2& x) { return domain_fault(x, h); }
bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(DomainWatch, LeavesGoodDomainsAlone) {
    EXPECT_EQ(fault({{0, 0}, {1, 0}, {0, 1}}), "");
    EXPECT_EQ(fault({{0, 0}, {2.9, 0.1}, {2.8, 1}, {0.1, 1.2}}), "");
    Corners2 heptagon;
    for (int c = 0; c < 7; ++c) heptagon.emplace_back(std::cos(2 * M_PI * c / 7), std::sin(2 * M_PI * c / 7));
    EXPECT_EQ(fault(heptagon), "");
    EXPECT_EQ(fault({{0, 0}, {2, 0}, {2, 1}, {1, 0.6}, {0, 1}}), "");  // polygons may be concave, as Voronoi cells at reflex corners are
    EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 1e-5}, {0, 1e-5}}), "");      // thin, but not collapsed
}
TEST(DomainWatch, NamesInvertedDomains) {
    EXPECT_TRUE(says(fault({{0, 0}, {0, 1}, {1, 0}}), "inside out"));
    EXPECT_TRUE(says(fault({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), "inside out"));
}
TEST(DomainWatch, NamesDomainsThatAreNoNumbers) {
    EXPECT_TRUE(says(fault({{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}, {0, 1}}), "inside out"));
}
// Its weights are positive and its area too: only the corner that turns right shows it (NUMBERS section 20).
TEST(DomainWatch, NamesDarts) { EXPECT_TRUE(says(fault({{0, 0}, {2, 0}, {0.4, 0.4}, {0, 2}}), "dart")); }
TEST(DomainWatch, NamesDomainsThatCrossThemselves) {
    EXPECT_TRUE(says(fault({{0, 0}, {2, 0}, {1.2, 1}, {1.5, -0.1}}), "crosses itself"));
    EXPECT_TRUE(says(fault({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0.5, -0.3}}), "crosses itself"));
}
TEST(DomainWatch, NamesCollapsedDomains) { EXPECT_TRUE(says(fault({{0, 0}, {1, 0}, {1, 1e-7}, {0, 1e-7}}), "collapsed")); }
TEST(DomainWatch, NamesLongDomainsAndTheRemedy) {
    const std::string text = fault({{0, 0}, {3.4, 0}, {3.4, 0.8}, {0, 0.8}});
    EXPECT_TRUE(says(text, "spans 3.4 cells"));
    EXPECT_TRUE(says(text, "split it"));
    EXPECT_EQ(domain_fault(Corners2{{0, 0}, {3.4, 0}, {3.4, 0.8}, {0, 0.8}}, Vec<2>(1.2, 1)), "");  // on a coarser grid
}

TEST(DomainWatch, NamesTheParticle) {
    const Lattice<2> lattice(Vec<2>(-1, -1), h, {8, 4});
    const Domains<DomainQ4, false> shape(lattice, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 0}, {5, 1}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
    std::vector<Point<2>> points(2);
    points[1].x = Vec<2>(3, 0.5);
    const Trouble trouble = check_domains(shape, points, h);
    EXPECT_EQ(trouble.cause, "domain-trouble");
    EXPECT_TRUE(says(trouble.reason, "particle 1 at x =")) << trouble.reason;
}

}  // namespace
}  // namespace mpm::test
