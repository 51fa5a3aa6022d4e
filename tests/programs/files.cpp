// What the programs write, where, and what they say when they cannot (DESIGN.md section 4).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

namespace fs = std::filesystem;

class Files : public testing::TestWithParam<std::string> {
protected:
    /// A small run with more words.
    Ending run(Words words) {
        words.insert(words.begin(), {"--cells", "10", "--periods", "1"});
        return folder.run(GetParam(), words);
    }
    Folder folder;
};
INSTANTIATE_TEST_SUITE_P(Programs, Files, testing::ValuesIn(programs()), program_name);

TEST_P(Files, AreHistorySummarySettingsAndFigure) {
    ASSERT_EQ(run({"--out", "run"}).code, 0);
    for (const std::string& name : Words{"history.csv", "summary.csv", "run.ini", GetParam() + ".gp"})
        EXPECT_TRUE(folder.has("run/" + name)) << name;
    EXPECT_EQ(folder.listing("run").size(), 4u) << "outputs that nobody asked for";
    EXPECT_EQ(expect_readable_files(folder, "run"), 2);
}
TEST_P(Files, NameFewRowsOfHistory) {
    ASSERT_EQ(run({"--out", "run", "--records", "7"}).code, 0);
    EXPECT_EQ(csv(folder.read("run/history.csv")).size(), 1u + 1 + 7);  // header, the start, 7 records
}
TEST_P(Files, HoldSnapshotsWhenAsked) {
    ASSERT_EQ(run({"--out", "run", "--frames", "3"}).code, 0);
    for (const std::string number : {"0000", "0001", "0002", "0003"}) {
        EXPECT_TRUE(folder.has("run/particles_" + number + ".csv")) << number;
        EXPECT_TRUE(folder.has("run/nodes_" + number + ".csv")) << number;
    }
    EXPECT_GE(expect_readable_files(folder, "run"), 2 + 8);
}

TEST_P(Files, SummaryHasTheFixedHeader) {
    ASSERT_EQ(run({"--out", "run"}).code, 0);
    const std::string summary = folder.read("run/summary.csv");
    EXPECT_EQ(
        summary.substr(0, summary.find('\n')),
        "program,case,scheme,shape,transfer,options,dim,cells,h,ppc,particles,dt,cfl,steps,t_end,threads,error_name,error,order,reference,"
        "energy_drift,momentum_drift,wall_s,cpu_s,ns_per_particle_step,peak_rss_kb,bytes_per_particle,bytes_per_node,verdict,t_fail,"
        "reason");
    const auto table = csv(summary);
    ASSERT_GT(table.size(), 1u);
    for (std::size_t row = 1; row < table.size(); ++row) {
        EXPECT_EQ(field(table, row, "program"), GetParam());
        EXPECT_EQ(field(table, row, "verdict"), "ok");
        EXPECT_EQ(field(table, row, "options"), "cells=10;periods=1");
        EXPECT_EQ(field(table, row, "reference"), "exact");
        EXPECT_NE(field(table, row, "error"), "nan");
        EXPECT_EQ(field(table, row, "t_fail"), "nan");
        EXPECT_EQ(field(table, row, "reason"), "");
    }
}

TEST_P(Files, RunIniRepeatsTheRun) {
    const std::vector<Words> runs{{"--mode", "3", "--alpha", "0.9", "--records", "77", "--shape", "cubic"},
                                  {"--dt", "0.01"},
                                  {"--dt-from", "step", "--cfl", "0.3", "--transfer", "xpic", "--order", "3"}};
    for (Words words : runs) {
        SCOPED_TRACE(testing::PrintToString(words));
        words.insert(words.end(), {"--out", "a"});
        ASSERT_EQ(run(words).code, 0);
        const Ending again = folder.run(GetParam(), {"--config", "a/run.ini", "--out", "b"});
        ASSERT_EQ(again.code, 0) << again.err;
        EXPECT_EQ(folder.read("a/history.csv"), folder.read("b/history.csv"));
        std::string ini = folder.read("b/run.ini");
        const auto out = ini.find("out = b");
        ASSERT_NE(out, std::string::npos);
        EXPECT_EQ(folder.read("a/run.ini"), ini.replace(out, 7, "out = a"));
    }
}
TEST_P(Files, RunIniSaysWhichVersionWroteIt) {
    ASSERT_EQ(run({"--out", "run"}).code, 0);
    std::string version = folder.run(GetParam(), {"--version"}).out;  // "musl_bar, MPM Lab 0.1"
    version = version.substr(version.find("MPM Lab"));
    version.pop_back();
    EXPECT_TRUE(holds(folder.read("run/run.ini"), version)) << version;
}

TEST_P(Files, OfAListGoToAFolderForEachResolution) {
    const Ending ending = folder.run(GetParam(), {"--cells", "8,16", "--periods", "1", "--out", "run"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    for (const char* name : {"run/cells-8/history.csv", "run/cells-16/history.csv", "run/summary.csv", "run/run.ini"})
        EXPECT_TRUE(folder.has(name));
    EXPECT_FALSE(folder.has("run/history.csv"));
    EXPECT_EQ(expect_readable_files(folder, "run"), 3) << "one summary for all";
    const auto table = csv(folder.read("run/summary.csv"));
    const std::size_t half = (table.size() - 1) / 2;
    EXPECT_EQ(table.size(), 2 * half + 1);
    EXPECT_EQ(field(table, half, "cells"), "8");
    EXPECT_EQ(field(table, half + 1, "cells"), "16");
    EXPECT_EQ(field(table, 1, "order"), "nan");
    EXPECT_NE(field(table, half + 1, "order"), "nan");
    EXPECT_TRUE(holds(ending.out, "seconds")) << "the table of error against run time";
}
TEST_P(Files, OfRepeatedRunsAreThoseOfOne) {
    ASSERT_EQ(run({"--out", "once"}).code, 0);
    ASSERT_EQ(run({"--out", "twice", "--repeat", "2"}).code, 0);
    EXPECT_EQ(folder.read("once/history.csv"), folder.read("twice/history.csv"));
    EXPECT_EQ(csv(folder.read("once/summary.csv")).size(), csv(folder.read("twice/summary.csv")).size());
}

TEST_P(Files, GoToAFolderNamedAfterWhatDiffers) {
    ASSERT_EQ(run({}).code, 0);
    ASSERT_EQ(run({"--mode", "10"}).code, 0);
    ASSERT_EQ(run({"--label", "mine"}).code, 0);
    const std::string place = "out/" + GetParam() + "/";
    for (const char* label : {"cells-10_periods-1", "mode-10_cells-10_periods-1", "mine"})
        EXPECT_TRUE(folder.has(place + label + "/run.ini")) << label;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path(place)), fs::directory_iterator()), 3);
}

TEST_P(Files, AreNotWrittenByADryRun) {
    const Ending ending = run({"--dry-run"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_TRUE(holds(ending.out, "steps")) << ending.out;
    EXPECT_TRUE(folder.empty());
}
TEST_P(Files, AreNotWrittenForAQuestion) {
    for (const char* question : {"--help", "--version", "--describe"}) {
        const Ending ending = run({question});
        EXPECT_EQ(ending.code, 0);
        EXPECT_NE(ending.out, "");
        EXPECT_EQ(ending.err, "");
    }
    EXPECT_TRUE(folder.empty());
}
TEST_P(Files, AreWrittenInSilence) {
    const Ending ending = run({"--quiet"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(ending.out + ending.err, "");
}
TEST_P(Files, AreNamedOnTheScreen) {
    const Ending ending = run({"--out", "run"});
    for (const auto& [path, content] : folder.listing("run"))
        EXPECT_TRUE(holds(ending.out, "run/" + fs::path(path).filename().string())) << path;
}

TEST_P(Files, ThatCannotBeReadAreNamed) {
    expect_one_line(run({"--config", "missing.ini"}), 1, {"missing.ini", "No such file"});
    expect_one_line(run({"--config", folder.path()}), 1, {folder.path(), "directory"});
    EXPECT_TRUE(folder.empty());
}
TEST_P(Files, ThatCannotBeWrittenAreNamed) {
    std::ofstream(folder.path("way")) << "in the way";
    for (const char* out : {"way", "way/below", "/proc/nothing/at/all"}) {
        const Ending ending = run({"--quiet", "--out", out});
        expect_one_line(ending, 1, {out});
    }
    EXPECT_EQ(folder.read("way"), "in the way");
}
TEST_P(Files, OnAFullDiskAreNamed) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    for (const char* name : {"history.csv", "summary.csv"}) {
        fs::remove_all(folder.path("run"));
        fs::create_directory(folder.path("run"));
        fs::create_symlink("/dev/full", folder.path(std::string("run/") + name));
        expect_one_line(run({"--quiet", "--out", "run"}), 1, {std::string("run/") + name, "No space left"});
    }
}

TEST(DryRun, CountsTheMappingsOfAStep) {
    const Folder folder;
    const auto seconds = [&](const char* order) {
        const std::string said = folder.run("tlmpm_bar", {"--dry-run", "--transfer", "fmpm", "--order", order}).out;
        const std::size_t at = said.rfind(" and ");
        return at == std::string::npos ? 0 : std::stod(said.substr(at + 5));
    };
    const double few = seconds("2"), many = seconds("64");
    EXPECT_GT(few, 0);
    EXPECT_GT(many, 8 * few);  // of 32 times as many mappings at least a quarter tells
}

}  // namespace
}  // namespace mpm::test
