/// Figure scripts: what they say, that gnuplot draws them, and that a picture that cannot be drawn is a reason and no failure.
#include "lab/figure.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lab/options.hpp"
#include "lab/record.hpp"

namespace {

namespace fs = std::filesystem;
using mpm::Panel;

std::string content(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
bool have_gnuplot() { return std::system("command -v gnuplot >/dev/null 2>&1") == 0; }

class Figure : public testing::Test {
protected:
    std::string folder = testing::TempDir() + "mpm figure's \"" + std::to_string(getpid()) + "\" $HOME";
    std::string why;
    const std::vector<Panel> panels{{"φ_I", "t", "t [s]", "v_{cm}", {{"v", "it's 5 %"}, {"w", "", "lines dt 2"}}, "[0:2]"}};

    void SetUp() override {
        fs::create_directories(folder);
        mpm::CsvFile csv(folder + "/history.csv", {"t", "v", "w"});
        for (int i = 0; i < 5; ++i) csv.row(std::vector<double>{i + 0.0, i * 0.5, i * 0.25}.data(), 3);
    }
    void TearDown() override { fs::remove_all(folder); }
    std::string write() { return mpm::write_figure(folder, "bar", "history.csv", "musl_bar", panels); }
};

TEST_F(Figure, NamesColumnsAndTexts) {
    const std::string path = write(), script = content(path);
    EXPECT_EQ(path, folder + "/bar.gp");
    EXPECT_TRUE(holds(script, "'history.csv' using (column('t')):(column('v')) with lines lt 1")) << script;
    EXPECT_TRUE(holds(script, "with lines dt 2 lw 2"));
    EXPECT_TRUE(holds(script, "set xrange [0:2]"));
    EXPECT_TRUE(holds(script, "it''s 5 %")) << "quotes in a text are doubled";
    EXPECT_FALSE(holds(script, folder)) << "the folder can be moved";
}
TEST_F(Figure, GivesLatexFormulas) {
    const std::string script = content(write());
    EXPECT_TRUE(holds(script, "(tex ? '$\\phi _I$' : 'φ_I')")) << script;
    EXPECT_TRUE(holds(script, "(tex ? '$v_{cm}$' : 'v_{cm}')"));
    EXPECT_TRUE(holds(script, "(tex ? 'musl\\_bar' : 'musl_bar')"));
    EXPECT_TRUE(holds(script, "it''s 5 \\%"));
}
TEST_F(Figure, LeavesNoPartialFile) {
    write();
    for (const auto& entry : fs::directory_iterator(folder)) EXPECT_FALSE(holds(entry.path().filename(), ".part")) << entry.path();
}
TEST_F(Figure, KeepsTheOldScriptWhenTheDiskIsFull) {
    const std::string path = write(), before = content(path);
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    const rlimit tiny{100, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &tiny);
    std::string said;
    try {
        mpm::write_figure(folder, "bar", "history.csv", "another title", panels);
    } catch (const mpm::FileTrouble& e) {
        said = e.what();
    }
    setrlimit(RLIMIT_FSIZE, &old);
    EXPECT_TRUE(holds(said, "File too large")) << said;  // not what closing the file says after that
    EXPECT_EQ(content(path), before);
    for (const auto& entry : fs::directory_iterator(folder)) EXPECT_FALSE(holds(entry.path().filename(), ".part")) << entry.path();
}
TEST_F(Figure, SaysWhereItCannotWrite) {
    try {
        mpm::write_figure(folder + "/none", "bar", "history.csv", "title", panels);
        FAIL() << "wrote into a folder that is not there";
    } catch (const mpm::FileTrouble& e) {
        EXPECT_TRUE(holds(e.what(), "none/bar.gp")) << e.what();
        EXPECT_TRUE(holds(e.what(), "No such file")) << e.what();
    }
}
TEST_F(Figure, DrawsEveryKindInAFolderWithQuotes) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    write();
    for (const std::string kind : {"png", "svg", "pdf", "tikz"}) {
        const std::string picture = mpm::draw_figure(folder, "bar", kind, why);
        EXPECT_EQ(picture, folder + "/bar." + (kind == "tikz" ? "tex" : kind)) << why;
        EXPECT_TRUE(fs::exists(picture) && fs::file_size(picture) > 500);
        EXPECT_FALSE(fs::exists(folder + "/gnuplot.log"));
    }
}
TEST_F(Figure, DrawsASurface) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    mpm::CsvFile csv(folder + "/square.csv", {"x", "y", "z"});
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) csv.row(std::vector<double>{i + 0.0, j + 0.0, i * j * 1.0}.data(), 3);
    mpm::write_figure(folder, "square", "square.csv", "a surface", {{"z", "x", "x", "y", {{"z", ""}}, "", "", "y", 3}}, 2);
    EXPECT_NE(mpm::draw_figure(folder, "square", "png", why), "") << why;
}
TEST_F(Figure, AMissingColumnIsAReason) {
    if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
    mpm::write_figure(folder, "bad", "history.csv", "title", {{"", "t", "t", "u", {{"no_such_column", "u"}}, ""}});
    EXPECT_EQ(mpm::draw_figure(folder, "bad", "png", why), "");
    EXPECT_TRUE(holds(why, "gnuplot.log")) << why;
    EXPECT_TRUE(fs::exists(folder + "/gnuplot.log"));
}
TEST_F(Figure, AMissingGnuplotIsAReason) {
    write();
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    const std::string picture = mpm::draw_figure(folder, "bar", "png", why);
    std::vector<std::string> files;
    testing::internal::CaptureStderr();
    mpm::add_picture(folder, "bar", "png", files);
    const std::string said = testing::internal::GetCapturedStderr();
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(picture, "");
    EXPECT_TRUE(holds(why, "not installed")) << why;
    EXPECT_TRUE(files.empty());
    EXPECT_TRUE(holds(said, "no picture: gnuplot is not installed")) << said;
}

}  // namespace
