// Polygons: which points they hold, area, and the outlines they refuse.
#include "lab/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <random>

#include "lab/options.hpp"
#include "lab/orientation.hpp"
#include "lab/record.hpp"

namespace mpm::test {
namespace {

const Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Outline box(double x, double y, double w) { return {{x, y}, {x + w, y}, {x + w, y + w}, {x, y + w}}; }

/// n corners at random distances from the origin, in order of their angle: simple, far from convex.
Outline star(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(0.3, 1);
    Outline corners = circle(Vec<2>::Zero(), 1, n);
    for (Vec<2>& x : corners) x *= between(random);
    return corners;
}
/// n teeth, each as high as the comb.
Outline comb(int n) {
    Outline corners{{0, -1}};
    corners.emplace_back(n, -1);
    for (int i = n; i > 0; --i) {
        corners.emplace_back(i, 0.1 * std::sin(i));
        corners.emplace_back(i - 0.5, 1 + 0.1 * std::sin(3 * i));
    }
    corners.emplace_back(0, 0);
    return corners;
}

/// Crossings of the ray to the right, edge by edge.
bool inside_by_all_edges(const std::vector<Outline>& outlines, const Vec<2>& x) {
    bool in = false;
    for (const Outline& o : outlines)
        for (std::size_t i = 0; i < o.size(); ++i) {
            const Vec<2>&a = o[i], &b = o[(i + 1) % o.size()];
            if ((a[1] <= x[1]) != (b[1] <= x[1]) && (orientation(a, b, x) > 0) == (b[1] > a[1])) in = !in;
        }
    return in;
}

TEST(Polygon, AgreesWithACountOfAllEdges) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-1.1, 1.1);
    for (const int n : {3, 4, 5, 7, 16, 33, 200}) {
        Outline reversed = star(n, 7);
        std::reverse(reversed.begin(), reversed.end());
        const Outline hole = circle(Vec<2>(0, 0), 0.02, 5);
        for (const std::vector<Outline>& outlines : {std::vector<Outline>{star(n, 7)}, {reversed}, {circle(Vec<2>(0, 0), 1, n), hole}}) {
            const Polygon polygon(outlines.front(), {outlines.begin() + 1, outlines.end()});
            for (int i = 0; i < 500; ++i) {
                const Vec<2> x(anywhere(random), anywhere(random));
                EXPECT_EQ(polygon.inside(x), inside_by_all_edges(outlines, x)) << n << ": " << x.transpose();
            }
        }
    }
}
TEST(Polygon, SharesNoPointOfAnEdgeWithItsNeighbour) {
    const Vec<2> middle(0.31, 0.47);  // four triangles of a square around it
    std::vector<Polygon> parts;
    for (std::size_t i = 0; i < 4; ++i) parts.emplace_back(Outline{square[i], square[(i + 1) % 4], middle});
    int held = 0;
    for (int i = 0; i <= 100; ++i)
        for (const Vec<2>& corner : square) {
            const Vec<2> x = middle + i / 100.0 * (corner - middle);
            const auto in = std::count_if(parts.begin(), parts.end(), [&](const Polygon& p) { return p.inside(x); });
            EXPECT_LE(in, 1);
            if (i < 100) {
                EXPECT_EQ(in, 1) << x.transpose();
            }
            held += static_cast<int>(in);
        }
    EXPECT_EQ(held, 401) << "and of the four corners of the square the lower left one";
}
TEST(Polygon, HoldsItsLeftAndLowerEdges) {
    const Polygon polygon(square);
    EXPECT_TRUE(polygon.inside({0, 0}) && polygon.inside({0.5, 0}) && polygon.inside({0, 0.5}));
    EXPECT_FALSE(polygon.inside({1, 0.5}) || polygon.inside({0.5, 1}) || polygon.inside({1, 1}));
}
TEST(Polygon, HasAnAreaEitherWayRound) {
    Outline clockwise = square;
    std::reverse(clockwise.begin(), clockwise.end());
    EXPECT_DOUBLE_EQ(signed_area(square), 1);
    EXPECT_DOUBLE_EQ(signed_area(clockwise), -1);
    EXPECT_DOUBLE_EQ(Polygon(clockwise).area(), 1);
    const Polygon frame(square, {box(0.25, 0.25, 0.5)});
    EXPECT_DOUBLE_EQ(frame.area(), 0.75);
    EXPECT_DOUBLE_EQ(frame.perimeter(), 6);
    EXPECT_FALSE(frame.inside({0.5, 0.5}));
    EXPECT_TRUE(frame.inside({0.1, 0.5}));
    EXPECT_EQ(frame.bounds().high, Vec<2>(1, 1));
}

std::string refusal(const std::function<void()>& make) {
    try {
        make();
    } catch (const BadInput& bad) {
        return bad.what();
    }
    return "none";
}
std::string refusal(const Outline& outer, const std::vector<Outline>& holes = {}) {
    return refusal([&] { Polygon(outer, holes); });
}

TEST(Polygon, RefusesWhatEnclosesNothing) {
    EXPECT_EQ(refusal(Outline{}), "polygon: the outline has 0 corners, at least 3 are needed");
    EXPECT_EQ(refusal(Outline{{0, 0}, {1, 1}}), "polygon: the outline has 2 corners, at least 3 are needed");
    EXPECT_EQ(refusal(Outline{{0, 0}, {1, 1}, {2, 2}, {0.5, 0.5}}), "polygon: the outline encloses no area: its corners lie on one line");
    EXPECT_EQ(refusal(square, {{{0.2, 0.2}, {0.3, 0.3}}}), "polygon: hole 1 has 2 corners, at least 3 are needed");
}
TEST(Polygon, RefusesWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = Bounds::inf;
    EXPECT_EQ(refusal(Outline{{0, 0}, {1, nan}, {1, 1}}), "polygon: corner 2 of the outline is (1, nan)");
    EXPECT_EQ(refusal(Outline{{0, 0}, {1, 0}, {inf, 1}}), "polygon: corner 3 of the outline is (inf, 1)");
}
TEST(Polygon, RefusesCornersThatAreThereTwice) {
    EXPECT_EQ(refusal(Outline{{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
              "polygon: corner 2 of the outline and corner 3 of the outline are the same, (1, 0)");
    EXPECT_EQ(refusal(Outline{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}),
              "polygon: corner 3 of the outline and corner 6 of the outline are the same, (1, 1)");
    EXPECT_NE(refusal(square, {{{0, 0}, {0.5, 0.2}, {0.2, 0.5}}}).find("corner 1 of hole 1 are the same"), std::string::npos);
}
TEST(Polygon, RefusesOutlinesThatCrossOrTouchThemselves) {
    const auto crosses = [](const Outline& outline) {
        return refusal(outline).find("the outline crosses or touches itself: edge") != std::string::npos;
    };
    EXPECT_TRUE(crosses({{0, 0}, {1, 1}, {1, 0}, {0, 1}})) << "a bow tie, of which the two areas cancel";
    EXPECT_TRUE(crosses({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}})) << "a corner on an edge";
    EXPECT_TRUE(crosses({{0, 0}, {2, 0}, {2, 1}, {3, 1}, {1.5, 1}, {0, 1}})) << "a spike";
    EXPECT_TRUE(crosses({{0, 0}, {3, 0}, {3, 1}, {2, 0}, {1, 0}, {0, 1}})) << "edges that lie on each other";
    EXPECT_TRUE(crosses({{0, 0}, {0, 2}, {0, 1}, {1, 1}})) << "a vertical spike";
    EXPECT_TRUE(crosses({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, -1}, {2, -1}, {2, 4}, {0, 4}}));
    EXPECT_NE(refusal(Outline{{0, 0}, {1, 1}, {1, 0}, {0, 1}}).find("edge 1 from (0, 0) to (1, 1), edge 3 from (0, 1) to (1, 0)"),
              std::string::npos);
}
TEST(Polygon, RefusesHolesThatCrossOrLieOutside) {
    const auto said = [](const std::vector<Outline>& holes, const std::string& part) {
        return refusal(square, holes).find(part) != std::string::npos;
    };
    EXPECT_TRUE(said({box(0.8, 0.4, 0.3)}, "the outline crosses or touches hole 1"));
    EXPECT_TRUE(said({box(0.2, 0.2, 0.3), box(0.4, 0.4, 0.3)}, "hole 1 crosses or touches hole 2"));
    EXPECT_TRUE(said({box(0.2, 0.2, 0.3), box(0.5, 0.2, 0.3)}, "the same")) << "holes side by side";
    EXPECT_TRUE(said({box(2, 2, 0.3)}, "hole 1 does not lie in the outline"));
    EXPECT_TRUE(said({box(-1, -1, 3)}, "hole 1 does not lie in the outline"));
    EXPECT_TRUE(said({box(0.1, 0.1, 0.8), box(0.3, 0.3, 0.2)}, "hole 2 does not lie in the outline, or lies in another hole"));
    EXPECT_EQ(refusal(square, {box(0.1, 0.1, 0.3), box(0.6, 0.6, 0.3)}), "none");
}

/// Whether any two edges meet, pair by pair, for outlines in general position.
bool any_two_cross(const Outline& o) {
    const std::size_t n = o.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n - (i == 0 ? 1 : 0); ++j) {
            const Vec<2>&a = o[i], &b = o[i + 1], &c = o[j], &d = o[(j + 1) % n];
            if (orientation(a, b, c) * orientation(a, b, d) <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0) return true;
        }
    return false;
}
TEST(Polygon, FindsTheCrossingsThatAllPairsOfEdgesShow) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0, 1);
    int crossing = 0, simple = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        Outline corners =
            trial % 2 == 0 ? star(3 + trial % 9, static_cast<unsigned>(trial)) : Outline(static_cast<std::size_t>(4 + trial % 4));
        if (trial % 2 == 1)
            for (Vec<2>& x : corners) x = Vec<2>(anywhere(random), anywhere(random));
        const bool crosses = any_two_cross(corners);
        ++(crosses ? crossing : simple);
        EXPECT_EQ(refusal(corners) != "none", crosses) << trial;
    }
    EXPECT_GT(crossing, 500);
    EXPECT_GT(simple, 500);
}
TEST(Polygon, FindsTheCrossingsOfOutlinesOnAGrid) {  // where edges touch, lie on each other and are vertical
    std::mt19937 random(5);
    std::uniform_int_distribution<int> place(0, 4);
    int refused = 0, accepted = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        Outline corners(static_cast<std::size_t>(3 + trial % 5));
        for (Vec<2>& x : corners) x = Vec<2>(place(random), place(random));
        bool twice = false;
        for (std::size_t i = 0; i < corners.size(); ++i) twice = twice || std::count(corners.begin(), corners.end(), corners[i]) > 1;
        if (twice) continue;
        bool bad = false;  // two edges that are not neighbours have a point in common, or two neighbours fold back
        const std::size_t n = corners.size();
        const auto at = [&](std::size_t i) -> const Vec<2>& { return corners[i % n]; };
        const auto on = [&](const Vec<2>& a, const Vec<2>& b, const Vec<2>& x) {
            return orientation(a, b, x) == 0 && (x - a).dot(x - b) <= 0;
        };
        for (std::size_t i = 0; i < n; ++i) {
            bad = bad || (orientation(at(i), at(i + 1), at(i + 2)) == 0 && (at(i) - at(i + 1)).dot(at(i + 2) - at(i + 1)) > 0);
            for (std::size_t j = i + 2; j < n && (i > 0 || j < n - 1); ++j)
                bad = bad || on(at(i), at(i + 1), at(j)) || on(at(i), at(i + 1), at(j + 1)) || on(at(j), at(j + 1), at(i)) ||
                      on(at(j), at(j + 1), at(i + 1)) ||
                      (orientation(at(i), at(i + 1), at(j)) * orientation(at(i), at(i + 1), at(j + 1)) < 0 &&
                       orientation(at(j), at(j + 1), at(i)) * orientation(at(j), at(j + 1), at(i + 1)) < 0);
        }
        ++(bad ? refused : accepted);
        EXPECT_EQ(refusal(corners) != "none", bad) << trial;
    }
    EXPECT_GT(refused, 500);
    EXPECT_GT(accepted, 500);
}
TEST(Polygon, IsTheSameInAnyUnit) {
    for (const double unit : {1e-140, 1e-3, 1e12, 1e140}) {
        Outline tie{{0, 0}, {unit, unit}, {unit, 0}, {0, unit}}, corners = star(50, 2);
        for (Vec<2>& x : corners) x *= unit;
        EXPECT_EQ(refusal(corners), "none") << unit;
        EXPECT_NE(refusal(tie), "none") << unit;
        EXPECT_NEAR(Polygon(corners).area() / unit / unit, Polygon(star(50, 2)).area(), 1e-14);
    }
}
TEST(Polygon, TakesAHundredThousandCorners) {
    for (const Outline& corners : {star(100000, 1), comb(50000)}) {
        const Polygon polygon(corners);
        const Bounds b = polygon.bounds();
        long inside = 0;
        constexpr int n = 316;  // 1e5 points; every test that took all edges would need 1e10 of them
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                inside += polygon.inside(b.low + (b.high - b.low).cwiseProduct(Vec<2>(i + 0.5, j + 0.5)) / n) ? 1 : 0;
        const double sampled = static_cast<double>(inside) / n / n;
        EXPECT_NEAR(sampled, polygon.area() / (b.high - b.low).prod(),
                    0.01);  // 1e5 samples of a rough outline: 3 standard deviations of chance
        Outline crossed = corners;
        std::swap(crossed[corners.size() / 3], crossed[corners.size() / 3 + 4]);
        EXPECT_NE(refusal(crossed), "none");
    }
}

TEST(Orientation, IsExact) {
    const Vec<2> a(0.5, 0.5), b(12, 12), c(24, 24);
    EXPECT_EQ(orientation(a, b, c), 0);
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j) {  // one unit in the last place is 2^-53: the known trial of plain arithmetic
            const Vec<2> x(0.5 + i * std::ldexp(1, -53), 0.5 + j * std::ldexp(1, -53));
            const Vec<2> stored(x[0], x[1]);
            const double dx = stored[0] - 0.5, dy = stored[1] - 0.5;  // exact
            EXPECT_EQ(orientation(stored, b, c), dy > dx ? 1 : dy < dx ? -1 : 0) << i << ' ' << j;
        }
}

class PolygonFile : public testing::Test {
protected:
    const std::string path = testing::TempDir() + "mpm_polygon.csv";
    void TearDown() override { std::filesystem::remove(path); }
    Polygon read(const std::string& text) const {
        write_file(path, text);
        return read_polygon(path);
    }
    std::string trouble(const std::string& text) const {
        try {
            read(text);
        } catch (const FileTrouble& bad) {
            return bad.what();
        }
        return "none";
    }
};
TEST_F(PolygonFile, IsRead) {
    const Polygon polygon = read("# a frame\n0, 0\n4 0\r\n4,\t4\n+0 , 4e0  # last\n0,0\n\n1,1\n2,1\n# between\n2,2\n\n");
    EXPECT_EQ(polygon.outlines().size(), 2u);
    EXPECT_EQ(polygon.outer().size(), 4u) << "the first corner again closes the outline";
    EXPECT_DOUBLE_EQ(polygon.area(), 15.5);
}
TEST_F(PolygonFile, IsRefusedWithItsLine) {
    for (const std::string line : {"x,y", "1", "1,", "1,,2", "1,2,3", "1;2", "1,2x", "0x1,2", "1e999,1", ",1,2"}) {
        const std::string said = trouble("0,0\n" + line + "\n1,1\n");
        EXPECT_NE(said.find("line 2 is not x, y: " + line), std::string::npos) << said;
    }
    EXPECT_NE(trouble(std::string("0,0\n\x01\x00\x7f\n", 9)).find("line 2"), std::string::npos);
    EXPECT_THROW(read("0,0\n1,0\n"), BadInput);
    EXPECT_THROW(read(""), BadInput);
    EXPECT_THROW(read("nan,0\n1,0\n1,1\n"), BadInput);
    EXPECT_THROW(read_polygon(testing::TempDir()), FileTrouble);
    EXPECT_THROW(read_polygon(path + ".missing"), FileTrouble);
}

}  // namespace
}  // namespace mpm::test
