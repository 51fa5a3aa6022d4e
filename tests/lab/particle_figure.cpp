/// Pictures of particles: animations and rows of snapshots.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lab/figure.hpp"
#include "lab/record.hpp"

namespace {

namespace fs = std::filesystem;

std::string content(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
bool have_gnuplot() { return std::system("command -v gnuplot >/dev/null 2>&1") == 0; }

class Animation : public testing::Test {
protected:
    std::string folder = testing::TempDir() + "mpm particles' " + std::to_string(getpid());
    std::string why;
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }
    void snapshot(const std::string& number, double shift) {
        mpm::CsvFile csv(folder + "/particles_" + number + ".csv", {"body", "x", "y", "v", "J", "V"});
        for (int i = 0; i < 4; ++i) csv.row(std::vector<double>{0, i + shift, i * 0.5, i - shift, 1.0, 0.25}.data(), 6);
    }
    /// Pictures in a gif: its graphic control extensions.
    static int pictures(const std::string& path) {
        const std::string gif = content(path), mark("\x21\xf9\x04", 3);
        int n = 0;
        for (std::size_t at = gif.find(mark); at != std::string::npos; at = gif.find(mark, at + 1)) ++n;
        return n;
    }
};

TEST_F(Animation, ListsItsFrames) {
    const auto files = mpm::write_animation(folder, "move", "a bar", {}, {{0, 0}, {3, 0.25}, {12345, 1.5}});
    EXPECT_EQ(files, (std::vector<std::string>{folder + "/frames.csv", folder + "/move.gp"}));
    EXPECT_EQ(content(files[0]), "frame,t,file\n0,0,particles_0000.csv\n3,0.25,particles_0003.csv\n12345,1.5,particles_12345.csv\n");
}
TEST_F(Animation, HasOnePictureForEachFrame) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    snapshot("0000", 0), snapshot("0002", 0.5), snapshot("0003", 1);
    mpm::write_animation(folder, "line", "a bar's motion", {}, {{0, 0}, {2, 0.25}, {3, 1}});
    EXPECT_EQ(mpm::draw_figure(folder, "line", "gif", why), folder + "/line.gif") << why;
    EXPECT_EQ(pictures(folder + "/line.gif"), 3);
}
TEST_F(Animation, ColoursPointsByAColumnEvenAConstantOne) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    snapshot("0000", 0), snapshot("0001", 0.5);
    mpm::write_animation(folder, "plane", "a disk", {"x", "y", "J", "x", "y", "J"}, {{0, 0}, {1, 0.25}});
    EXPECT_NE(mpm::draw_figure(folder, "plane", "gif", why), "") << why;
    EXPECT_EQ(pictures(folder + "/plane.gif"), 2);
}
TEST_F(Animation, AMissingSnapshotIsAReason) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    snapshot("0000", 0);
    mpm::write_animation(folder, "line", "a bar", {}, {{0, 0}, {1, 0.25}});
    EXPECT_EQ(mpm::draw_figure(folder, "line", "gif", why), "");
}

using ParticleFigure = Animation;
const mpm::Animated plane{"x", "y", "v", "x", "y", "speed |v| [length/time]"};

TEST_F(ParticleFigure, ShowsUpToFourSnapshotsTheFirstAndTheLastAmongThem) {
    std::vector<mpm::Frame> frames;
    for (long i = 0; i <= 10; ++i) frames.push_back({i, 0.1 * static_cast<double>(i)});
    const std::string many = content(mpm::write_particle_figure(folder, "row", "a disk", plane, frames));
    EXPECT_TRUE(holds(many, "['particles_0000.csv', 'particles_0003.csv', 'particles_0006.csv', 'particles_0010.csv']")) << many;
    frames.resize(2);
    const std::string two = content(mpm::write_particle_figure(folder, "row", "a disk", plane, frames));
    EXPECT_TRUE(holds(two, "n = 2\narray T[2] = [0, 0.1]")) << two;
    frames.resize(1);
    EXPECT_TRUE(holds(content(mpm::write_particle_figure(folder, "row", "a disk", plane, frames)), "['particles_0000.csv']"));
}
TEST_F(ParticleFigure, IsDrawnInEveryKind) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    snapshot("0000", 0), snapshot("0001", 0.5), snapshot("0002", 1);
    mpm::write_particle_figure(folder, "row", "it's a_disk", plane, {{0, 0}, {1, 0.25}, {2, 1}});
    for (const std::string kind : {"png", "svg", "pdf", "tikz"}) {
        const std::string picture = mpm::draw_figure(folder, "row", kind, why);
        EXPECT_EQ(picture, folder + "/row." + (kind == "tikz" ? "tex" : kind)) << why;
        EXPECT_GT(fs::file_size(picture), 1000u);
    }
}
TEST_F(ParticleFigure, IsDrawnOfWideBodiesAndOfOneValue) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    mpm::CsvFile csv(folder + "/particles_0000.csv", {"x", "y", "body", "V"});
    for (int i = 0; i < 10; ++i) csv.row(std::vector<double>{i + 0.5, 0.5, 0, 1}.data(), 4);
    mpm::write_particle_figure(folder, "wide", "a bar", {"x", "y", "body", "x", "y", "body"}, {{0, 0}, {0, 1}});
    EXPECT_NE(mpm::draw_figure(folder, "wide", "png", why), "") << why;
}
TEST_F(ParticleFigure, KnowsTheLabelsOfColumns) {
    EXPECT_EQ(mpm::column_label("mises"), "von Mises stress [force/area]");
    EXPECT_EQ(mpm::column_label("sxx_smooth"), "stress σ_{xx}, smoothed [force/area]");
    EXPECT_EQ(mpm::column_label("plastic_strain"), "plastic strain");
}

}  // namespace
