// two_disks as a user runs it: snapshots, their formats, smoothed stresses, pictures, and what it refuses.
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

const char* const program = "two_disks";

class TwoDisksSnapshots : public testing::Test {
protected:
    /// A run to 1.9, when the disks are pressed together.
    void run(Words words) {
        words.insert(words.end(), {"--t-end", "1.9", "--records", "20", "--cfl", "0.3", "--out", "run", "--quiet"});
        const Ending ending = folder.run(program, words);
        ASSERT_EQ(ending.code, 0) << ending.err;
    }
    std::vector<Words> last(const std::string& number) const { return csv(folder.read("run/particles_" + number + ".csv")); }
    static double number(const std::vector<Words>& table, std::size_t row, const std::string& column) {
        return std::stod(field(table, row, column));
    }
    Folder folder;
};

// Plane strain: szz = nu (sxx + syy) of the law in rate form.
TEST_F(TwoDisksSnapshots, SnapshotsTellStressesThatBelongTogether) {
    run({"--frames", "1"});
    const auto table = last("0001");
    for (std::size_t row = 1; row < table.size(); ++row) {
        const auto at = [&](const char* column) { return number(table, row, column); };
        const double xx = at("sxx"), yy = at("syy"), zz = at("szz"), scale = 1e-12 * (std::abs(xx) + std::abs(yy) + 1);
        ASSERT_NEAR(zz, 0.3 * (xx + yy), scale);
        ASSERT_NEAR(at("pressure"), -(xx + yy + zz) / 3, scale);
        ASSERT_NEAR(at("speed"), std::hypot(at("vx"), at("vy")), 1e-14);
        ASSERT_GE(at("mises"), 0);
    }
}
TEST_F(TwoDisksSnapshots, NeoHookeanDisksFeelTheirVolumeAcrossThePlane) {
    run({"--frames", "1", "--law", "neo-hookean"});
    const auto table = last("0001");
    const double lambda = 1000 * 0.3 / (1.3 * 0.4);
    for (std::size_t row = 1; row < table.size(); ++row) {
        const double J = number(table, row, "J");
        ASSERT_NEAR(number(table, row, "szz"), lambda * std::log(J) / J, 1e-9);  // J is printed exactly; it was det F
    }
}
// All particles have one mass: the sum of a component is kept, and its spread falls.
TEST_F(TwoDisksSnapshots, SmoothedStressKeepsItsSumAndLosesItsNoise) {
    for (const char* scheme : {"usl", "usf", "musl"})
        for (const char* shape : {"hat", "cubic"}) {
            run({"--frames", "1", "--smooth", "--scheme", scheme, "--shape", shape});
            const auto table = last("0001");
            double sum = 0, smooth = 0, squares = 0, smooth_squares = 0, size = 0;
            for (std::size_t row = 1; row < table.size(); ++row) {
                const double a = number(table, row, "sxx"), b = number(table, row, "sxx_smooth");
                sum += a, smooth += b, squares += a * a, smooth_squares += b * b, size += std::abs(a);
            }
            EXPECT_NEAR(smooth, sum, 1e-12 * size) << scheme << " " << shape;
            EXPECT_LT(smooth_squares, squares) << scheme << " " << shape;
        }
}
TEST_F(TwoDisksSnapshots, VtkTakesThePlaceOfCsv) {
    run({"--frames", "2", "--format", "vtk"});
    for (const char* name : {"particles_0000.vtk", "particles_0002.vtk", "nodes_0001.vtk", "particles.vtk.series", "nodes.vtk.series"})
        EXPECT_TRUE(folder.has(std::string("run/") + name)) << name;
    EXPECT_FALSE(folder.has("run/particles_0000.csv"));
    EXPECT_FALSE(folder.has("run/two_disks_particles.gp")) << "a picture of files that are not there";
    const std::string head = "# vtk DataFile Version 3.0\nparticles_0000, t = 0\nBINARY\nDATASET POLYDATA\nPOINTS 416 double\n";
    EXPECT_TRUE(folder.read("run/particles_0000.vtk").starts_with(head));
}
TEST_F(TwoDisksSnapshots, PicturesHaveTheirCsvBesideVtk) {
    run({"--format", "vtk", "--plot", "png"});
    for (const char* name : {"particles_0003.vtk", "particles_0003.csv", "nodes_0003.vtk", "two_disks_particles.gp"})
        EXPECT_TRUE(folder.has(std::string("run/") + name)) << name;
    EXPECT_FALSE(folder.has("run/nodes_0003.csv"));
}
TEST_F(TwoDisksSnapshots, APictureTakesFourSnapshotsUnlessTold) {
    run({"--plot", "png"});
    EXPECT_TRUE(folder.has("run/particles_0003.csv"));
    EXPECT_FALSE(folder.has("run/particles_0004.csv"));
    EXPECT_TRUE(holds(folder.read("run/two_disks_particles.gp"), "column('mises')"));
    EXPECT_TRUE(holds(folder.read("run/two_disks.gp"), "column('momentum_y')"));
}
TEST_F(TwoDisksSnapshots, NoSnapshotsMeansNone) {
    run({"--plot", "png", "--frames", "0"});
    EXPECT_FALSE(folder.has("run/particles_0000.csv"));
    EXPECT_FALSE(folder.has("run/two_disks_particles.gp"));
}
TEST_F(TwoDisksSnapshots, ColoursAreOfTheColumnAskedFor) {
    run({"--frames", "3", "--smooth", "--colour", "pressure_smooth"});
    for (const char* name : {"run/two_disks_particles.gp", "run/two_disks_animation.gp"}) {
        const std::string script = folder.read(name);
        EXPECT_TRUE(holds(script, "column('pressure_smooth')")) << script;
        EXPECT_TRUE(holds(script, "set cblabel 'pressure, smoothed [force/area]'")) << script;
    }
}
// What is watched is no part of what is computed.
TEST_F(TwoDisksSnapshots, SnapshotsChangeNothing) {
    run({});
    const std::string before = folder.read("run/history.csv");
    run({"--frames", "4", "--smooth", "--format", "vtk", "--colour", "speed"});
    EXPECT_EQ(folder.read("run/history.csv"), before);
    EXPECT_EQ(field(csv(folder.read("run/summary.csv")), 1, "options"), "cfl=0.3;t-end=1.9");
}
TEST_F(TwoDisksSnapshots, RefusesWhatMeansNothing) {
    for (const auto& [words, parts] : std::vector<std::pair<Words, Words>>{
             {{"--periods", "2"}, {"--periods"}},
             {{"--colour", "mises_smooth"}, {"--colour mises_smooth", "--smooth"}},
             {{"--colour", "stress"}, {"--colour", "stress", "mises, speed"}},
             {{"--format", "vtu"}, {"--format", "vtu", "csv, vtk"}}}) {
        expect_one_line(folder.run(program, words), 2, parts);
        EXPECT_TRUE(folder.empty());
    }
}
TEST(Colours, AreRefusedWhereNothingIsColoured) {
    const Folder folder;
    expect_one_line(folder.run("mms_segment", {"--colour", "speed"}), 2, {"--colour"});
}

}  // namespace
}  // namespace mpm::test
