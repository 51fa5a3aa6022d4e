// compare: sweeps that are resumed, listed, collected or interrupted.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/plots/fakes.hpp"

namespace mpm::test {
namespace {

namespace fs = std::filesystem;
const Words two{"--cells", "10,20", "--out", "all", "--", "good", "--mode", "3", "--", "better"};

Words with(Words words, const Words& more) {
    words.insert(words.begin(), more.begin(), more.end());
    return words;
}

/// The stacked rows without what is measured anew in each run.
std::vector<Words> without_measurements(const std::string& text) {
    std::vector<Words> table = csv(text);
    for (std::size_t c = 0; c < table[0].size(); ++c) {
        const std::string name = table[0][c];
        if (name != "wall_s" && name != "cpu_s" && name != "ns_per_particle_step" && name != "peak_rss_kb") continue;
        for (std::size_t r = 1; r < table.size(); ++r) table[r][c] = "";
    }
    return table;
}

/// Runs each printed line by a shell, as GNU parallel does.
void run_lines(const Fakes& fakes, const std::string& text, std::size_t limit = 1000) {
    std::istringstream lines(text);
    for (std::string line; limit > 0 && std::getline(lines, line); --limit) {
        std::ofstream(fakes.path("line.sh")) << line << "\n";
        EXPECT_EQ(std::system(("sh '" + fakes.path("line.sh") + "'").c_str()), 0) << line;
    }
}

TEST(Resume, RunsNothingTwice) {
    const Fakes fakes;
    fakes.tool("compare", two);
    const std::string before = fakes.read("all/compare.csv");
    const Ending again = fakes.tool("compare", two);
    EXPECT_EQ(again.code, 0);
    EXPECT_TRUE(holds(again.out, "4 of 4 runs are taken from an earlier sweep")) << again.out;
    EXPECT_EQ(fakes.runs(), 4);
    EXPECT_EQ(fakes.read("all/compare.csv"), before);
}
TEST(Resume, RunsWhatIsMissing) {
    const Fakes fakes;
    fakes.tool("compare", two);
    fs::remove(fakes.path("all/runs/better/cells-20/exit_code"));
    fakes.tool("compare", two);
    EXPECT_EQ(fakes.runs(), 5);
    EXPECT_TRUE(fakes.read("bin/log").ends_with("better 20\n"));
}
TEST(Resume, GoesOnToMoreResolutions) {
    const Fakes fakes;
    fakes.tool("compare", {"--cells", "10", "--out", "all", "--", "good"});
    fakes.tool("compare", {"--cells", "10,20", "--out", "all", "--", "good"});
    EXPECT_EQ(fakes.runs(), 2);
    EXPECT_EQ(csv(fakes.read("all/compare.csv")).size(), 5u);
}
TEST(Resume, FreshRunsAllAgain) {
    const Fakes fakes;
    fakes.tool("compare", two);
    fakes.tool("compare", with(two, {"--fresh"}));
    EXPECT_EQ(fakes.runs(), 8);
}
TEST(Resume, RunsFailuresAgain) {
    const Fakes fakes;
    for (int i = 0; i < 2; ++i) fakes.tool("compare", {"--cells", "10", "--out", "all", "--", "fails", "--", "unstable"});
    EXPECT_EQ(fakes.runs(), 3);  // the unstable run has a result
}
TEST(Resume, RunsAgainWhatWasBuiltSince) {
    const Fakes fakes;
    fakes.tool("compare", two);
    fs::last_write_time(fakes.path("bin/good"), fs::file_time_type::clock::now() + std::chrono::seconds(10));
    fakes.tool("compare", two);
    EXPECT_EQ(fakes.runs(), 6);
}
TEST(Resume, RunsAgainWhatHadOtherOptions) {
    const Fakes fakes;
    fakes.tool("compare", two);
    std::ofstream(fakes.path("all/runs/good_mode-3/cells-10/command.txt")) << "good --mode 4 --cells 10 --quiet\n";
    fakes.tool("compare", two);
    EXPECT_EQ(fakes.runs(), 5);
}

TEST(ListAndCollect, GiveTheRowsOfASerialRun) {
    const Words bad{"--cells", "10,100", "--", "good", "--mode", "3", "--", "unstable", "--", "crashes", "--", "fails", "--", "silent"};
    const Fakes fakes;
    EXPECT_EQ(fakes.tool("compare", with(bad, {"--out", "serial"})).code, 3);
    const Ending list = fakes.tool("compare", with(bad, {"--out", "listed", "--list"}));
    EXPECT_EQ(list.code, 0) << list.err;
    EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '\n'), 10);
    EXPECT_EQ(fakes.runs(), 10);  // the serial ones: listing runs nothing
    run_lines(fakes, list.out);
    EXPECT_EQ(fakes.runs(), 20);
    const Ending collected = fakes.run("compare", {"--collect", "listed", "--plot", "none"});
    EXPECT_EQ(collected.code, 3);
    EXPECT_EQ(without_measurements(fakes.read("listed/compare.csv")), without_measurements(fakes.read("serial/compare.csv")));
    EXPECT_TRUE(holds(collected.out, "good, mode = 3")) << collected.out;
}
TEST(ListAndCollect, ShowWhatHasNotEnded) {
    const Fakes fakes;
    run_lines(fakes, fakes.tool("compare", with(two, {"--list"})).out, 3);
    EXPECT_EQ(fakes.run("compare", {"--collect", "all", "--plot", "none"}).code, 3);
    const auto table = csv(fakes.read("all/compare.csv"));
    ASSERT_EQ(table.size(), 8u);
    EXPECT_EQ(field(table, 7, "verdict"), "failed:not ended");
    const Ending rest = fakes.tool("compare", with(two, {"--list"}));
    EXPECT_EQ(std::count(rest.out.begin(), rest.out.end(), '\n'), 1);
    EXPECT_TRUE(holds(rest.err, "3 of 4 runs have ended already")) << rest.err;
}
TEST(ListAndCollect, WorkFromAnotherFolder) {
    const Fakes fakes;
    const Ending list = fakes.tool("compare", with(two, {"--list"}));
    std::ofstream(fakes.path("all.sh")) << "cd /\n" << list.out;
    EXPECT_EQ(std::system(("sh '" + fakes.path("all.sh") + "'").c_str()), 0);
    fs::rename(fakes.path("all"), fakes.path("moved"));
    EXPECT_EQ(fakes.run("compare", {"--collect", "moved", "--plot", "none"}).code, 0);
    EXPECT_EQ(csv(fakes.read("moved/compare.csv")).size(), 9u);
}

TEST(Jobs, GiveTheSameRows) {
    const Fakes fakes;
    EXPECT_EQ(fakes.tool("compare", two).code, 0);
    const std::string one = fakes.read("all/compare.csv");
    EXPECT_EQ(fakes.tool("compare", with(two, {"--fresh", "--jobs", "3"})).code, 0);
    EXPECT_EQ(without_measurements(fakes.read("all/compare.csv")), without_measurements(one));
}

TEST(Interrupted, SweepEndsItsRunAndKeepsTheRowsSoFar) {
    const Fakes fakes;
    const Words words = fakes.told({"--cells", "10", "--out", "all", "--", "good", "--", "hangs"});
    const pid_t sweep = fakes.start("compare", words);
    for (int i = 0; i < 500 && !fakes.has("bin/pid"); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(fakes.has("bin/pid"));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // its number is written
    kill(sweep, SIGTERM);
    const Ending ending = fakes.finish(sweep);
    EXPECT_EQ(ending.code, 130);
    EXPECT_TRUE(holds(ending.err, "interrupted")) << ending.err;
    EXPECT_EQ(csv(fakes.read("all/compare.csv")).size(), 3u);
    EXPECT_NE(kill(static_cast<pid_t>(std::stol(fakes.read("bin/pid"))), 0), 0) << "the run is still there";
    EXPECT_EQ(fakes.tool("compare", {"--cells", "10", "--timeout", "0.2", "--out", "all", "--", "good", "--", "hangs"}).code, 3);
    EXPECT_EQ(fakes.runs(), 3);  // the good one is not run again
}

}  // namespace
}  // namespace mpm::test
