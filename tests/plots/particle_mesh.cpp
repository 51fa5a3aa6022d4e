// A mesh between particles: what it fills, what it leaves open, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <utility>

#include "lab/options.hpp"
#include "plots/particle_triangles.hpp"
#include "tests/programs/process.hpp"

namespace mpm {
namespace {

/// Columns body, x, y, q = x + 2 y of the places of a lattice with spacing 0.1 that `inside` keeps.
template <class Inside> Snapshot lattice(Inside&& inside, double stretch = 1) {
    Snapshot s{{"body", "x", "y", "q"}};
    for (int j = 0; j < 20; ++j)
        for (int i = 0; i < 20; ++i) {
            const double x = 0.1 * stretch * (i + 0.5), y = 0.1 * (j + 0.5);
            if (inside(x, y)) s.add(std::array<double, 4>{0, x, y, x + 2 * y});
        }
    return s;
}
double area(const Snapshot& s, const std::vector<Triangle>& triangles) {
    double sum = 0;
    for (const Triangle& t : triangles) {
        const auto x = [&](std::size_t k) { return s.at(t[k], 1); };
        const auto y = [&](std::size_t k) { return s.at(t[k], 2); };
        const double twice = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
        EXPECT_GT(twice, 0) << "counter-clockwise";
        sum += twice / 2;
    }
    return sum;
}

TEST(ParticleMesh, FillsASquare) {
    const Snapshot s = lattice([](double, double) { return true; });
    const ParticleMesh mesh = mesh_of(s, "square");
    EXPECT_EQ(mesh.triangles.size(), 2u * 19 * 19);
    EXPECT_NEAR(area(s, mesh.triangles), 1.9 * 1.9, 1e-12);
    EXPECT_NEAR(mesh.max_edge, 0.2, 1e-12);  // twice the spacing, which two of three edges have
    EXPECT_EQ(mesh.dropped, 0u);
}
TEST(ParticleMesh, FillsABodyThatIsStretched) {
    const Snapshot s = lattice([](double, double) { return true; }, 3);
    EXPECT_NEAR(area(s, mesh_of(s, "stretched").triangles), 5.7 * 1.9, 1e-12);
}
TEST(ParticleMesh, LeavesHolesAndGapsOpen) {
    const auto ring = [](double x, double y) {
        const double r = std::hypot(x - 1, y - 1);
        return r < 1 && r > 0.5;
    };
    const Snapshot s = lattice(ring);
    const double pi = std::numbers::pi, half_spacing = 0.05, around = 3 * pi;
    EXPECT_NEAR(area(s, mesh_of(s, "ring").triangles), 0.75 * pi - half_spacing * around, half_spacing * around);
    const Snapshot two = lattice([](double x, double) { return x < 0.8 || x > 1.1; });  // 0.4 apart
    EXPECT_NEAR(area(two, mesh_of(two, "gap").triangles), 1.9 * (0.7 + 0.8), 1e-12);
    EXPECT_NEAR(area(two, mesh_of(two, "gap", 10).triangles), 1.9 * 1.9, 1e-12) << "unless told";
}
TEST(ParticleMesh, KeepsBodiesApartHoweverNear) {
    Snapshot s = lattice([](double, double) { return true; });
    for (std::size_t row = 0; row < s.rows(); ++row) s.values[4 * row] = s.at(row, 1) > 1 ? 1 : 0;
    const ParticleMesh mesh = mesh_of(s, "two", 10);
    EXPECT_NEAR(area(s, mesh.triangles), 2 * 0.9 * 1.9, 1e-12);
    for (const Triangle& t : mesh.triangles) EXPECT_TRUE(s.at(t[0], 0) == s.at(t[1], 0) && s.at(t[1], 0) == s.at(t[2], 0));
}

class ParticleMeshProgram : public testing::Test {
protected:
    test::Folder folder;
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder.path(name)) << text; }
    void expect_refused(const std::string& text, const test::Words& parts, const test::Words& more = {}) const {
        write("p.csv", text);
        test::Words words{"p.csv", "--out", "mesh"};
        words.insert(words.end(), more.begin(), more.end());
        test::expect_one_line(folder.run("particle_mesh", words), 2, parts);
        EXPECT_FALSE(folder.has("mesh"));
    }
};

TEST_F(ParticleMeshProgram, WritesVtkAndAPicture) {
    write("p_0007.csv", "x,y,mises\n0,0,1\n1,0,2\n0,1,3\n1,1.1,4\n");
    const auto ending = folder.run("particle_mesh", {"p_0007.csv", "--plot", "png"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(test::holds(ending.out, "4 particles, 2 triangles")) << ending.out;
    EXPECT_TRUE(test::holds(folder.read("p_0007_mesh.vtk"), "POLYGONS 2 8\n"));
    EXPECT_TRUE(test::holds(folder.read("p_0007_mesh.gp"), "von Mises stress"));
    if (std::system("command -v gnuplot >/dev/null 2>&1") == 0) {
        EXPECT_TRUE(folder.has("p_0007_mesh.png")) << ending.err;
    }
}
TEST_F(ParticleMeshProgram, RefusesWhatMakesNoMesh) {
    const std::string corners = "x,y,q\n0,0,1\n1,0,2\n0,1,3\n";
    expect_refused("x,y,q\n0,0,1\n1,0,2\n", {"p.csv", "too few particles (2)"});
    expect_refused("x,y\n", {"p.csv", "too few particles (0)"});
    expect_refused("x,y,q\n0,0,1\n1,1,2\n2,2,2\n", {"p.csv", "on one line"});
    expect_refused("x,y,q\n0,0,1\n1,nan,2\n2,2,2\n", {"p.csv", "row 2", "not a number"});
    expect_refused("x,y,q\n0,0,1\n1,0,2\n0,0,3\n0,1,3\n", {"p.csv", "rows 1 and 3", "same place"});
    expect_refused("body,x,y\n0,0,0\n0,1,0\n0,0,1\n4,5,5\n", {"p.csv, body 4", "too few particles (1)"});
    expect_refused("t,v\n0,1\n", {"p.csv", "no columns x and y"});
    expect_refused(corners, {"--colour pressure", "x, y, q"}, {"--colour", "pressure"});
    expect_refused(corners, {"--max-edge 0.5", "p.csv"}, {"--max-edge", "0.5"});
    expect_refused(corners, {"--max-edge", "-1"}, {"--max-edge", "-1"});
}
TEST_F(ParticleMeshProgram, NamesWhatItCannotRead) {
    test::expect_one_line(folder.run("particle_mesh", {"missing.csv"}), 1, {"missing.csv", "No such file"});
    test::expect_one_line(folder.run("particle_mesh", {}), 2, {"no snapshot", "particle_mesh particles_0000.csv"});
    test::expect_one_line(folder.run("particle_mesh", {"--max-edges", "1"}), 2, {"--max-edges", "--max-edge"});
}

}  // namespace
}  // namespace mpm
