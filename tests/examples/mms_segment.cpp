// mms_segment and fem_bar as a user runs them: what they write, and what they refuse.
#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

const char* const program = "mms_segment";

/// A small run that must end well; its summary.
std::vector<Words> summary(const Folder& folder, const std::string& name, Words words) {
    words.insert(words.end(), {"--quiet", "--out", "run"});
    const Ending ending = folder.run(name, words);
    EXPECT_EQ(ending.code, 0) << ending.err;
    return csv(folder.read("run/summary.csv"));
}

TEST(MmsSegment, WritesThreeNormsOfEachResolutionWithTheirOrders) {
    const Folder folder;
    const auto table = summary(folder, program, {"--cells", "8,16,32"});
    ASSERT_EQ(table.size(), 1u + 9u);
    for (std::size_t row = 1; row < table.size(); ++row) {
        EXPECT_EQ(field(table, row, "error_name"), (Words{"rmse", "e1", "e2"}[row % 3]));
        EXPECT_EQ(field(table, row, "reference"), "manufactured");
        EXPECT_EQ(field(table, row, "case"), "segment");
        EXPECT_EQ(field(table, row, "verdict"), "ok");
        if (row > 3) { EXPECT_NEAR(std::stod(field(table, row, "order")), 2, 0.1); }
    }
}

TEST(MmsSegment, RunsEverySchemeAndShape) {
    const std::map<std::string, Words> all{{"usl", {"hat", "ugimp", "cpgimp", "quadratic", "cubic"}},
                                           {"usf", {"hat", "cubic"}},
                                           {"musl", {"hat", "cpgimp"}},
                                           {"tlmpm", {"hat", "ugimp", "cpgimp", "quadratic", "cubic", "bernstein"}},
                                           {"impm", {"hat"}},
                                           {"fem", {"hat", "lagrange"}}};
    for (const auto& [scheme, shapes] : all)
        for (const std::string& shape : shapes) {
            const Folder folder;
            const auto table = summary(folder, program, {"--scheme", scheme, "--shape", shape, "--cells", "8", "--ppc", "2"});
            EXPECT_EQ(field(table, 1, "scheme"), scheme == "fem" ? "fem-total" : scheme);
            EXPECT_EQ(field(table, 1, "shape"), shape);
        }
}

// The period is 2/sqrt(E/rho), whatever E; --t-end takes its place.
TEST(MmsSegment, RunsForOnePeriodUnlessTold) {
    const Folder folder;
    EXPECT_NEAR(std::stod(field(summary(folder, program, {"--cells", "8"}), 1, "t_end")), 0.02, 1e-12);
    EXPECT_NEAR(std::stod(field(summary(folder, program, {"--cells", "8", "--E", "1000"}), 1, "t_end")), 2, 1e-12);
    EXPECT_NEAR(std::stod(field(summary(folder, program, {"--cells", "8", "--t-end", "0.005"}), 1, "t_end")), 0.005, 1e-12);
    EXPECT_NEAR(std::stod(field(summary(folder, program, {"--cells", "8", "--periods", "0.5"}), 1, "t_end")), 0.01, 1e-12);
}

TEST(MmsSegment, RepeatsItsRunFromTheSettings) {
    const Folder folder;
    const Words words{"--cells", "8", "--scheme", "fem", "--shape", "lagrange", "--ppc", "2", "--G", "0.05", "--E", "1000", "--out", "a"};
    ASSERT_EQ(folder.run(program, words).code, 0);
    ASSERT_EQ(folder.run(program, {"--config", "a/run.ini", "--out", "b"}).code, 0);
    EXPECT_EQ(folder.read("a/history.csv"), folder.read("b/history.csv"));
}

// Review 6.2.1: the standard MPM does not converge at large amplitude; its fine grids must say so, and a stopped run has no error.
TEST(MmsSegment, SaysWhereTheStandardMpmFails) {
    const Folder folder;
    const auto run = [&](const char* cells, const char* watch) {
        const Words words{"--scheme", "usf", "--ppc", "2", "--G", "0.05", "--cells", cells, "--watch", watch, "--out", "run"};
        return folder.run(program, words).code;
    };
    EXPECT_EQ(run("16,256", "stop"), 3);
    const auto table = csv(folder.read("run/summary.csv"));
    ASSERT_EQ(table.size(), 1u + 6u);
    EXPECT_EQ(field(table, 1, "verdict"), "ok");
    EXPECT_EQ(field(table, 4, "verdict"), "unstable:energy-growth");
    EXPECT_EQ(field(table, 4, "error"), "nan");
    EXPECT_EQ(run("256", "warn"), 3);
}

TEST(MmsSegment, RefusesWhatDoesNotGoTogether) {
    for (const auto& [words, parts] : std::vector<std::pair<Words, Words>>{
             {{"--scheme", "usl", "--shape", "bernstein"}, {"--shape bernstein", "--scheme usl", "cpgimp"}},
             {{"--scheme", "tlmpm", "--shape", "lagrange", "--ppc", "2"}, {"--shape lagrange", "--scheme tlmpm", "bernstein"}},
             {{"--scheme", "fem", "--shape", "cubic"}, {"--shape cubic", "--scheme fem", "lagrange"}},
             {{"--scheme", "fem", "--shape", "lagrange", "--ppc", "1"}, {"--ppc 1", "lagrange", ">= 2"}},
             {{"--scheme", "fem", "--points", "mid"}, {"--points mid", "Gauss"}},
             {{"--scheme", "fem", "--alpha", "0.5"}, {"--alpha", "fem"}},
             {{"--scheme", "musl", "--formulation", "updated"}, {"--formulation", "musl"}},
             {{"--shape", "cpgimp", "--points", "gauss", "--ppc", "3"}, {"--points gauss", "cpgimp", "1 or 2"}},
             {{"--scheme", "impm", "--shape", "cubic"}, {"--shape cubic", "impm", "hat"}},
             {{"--scheme", "impm", "--transfer", "apic"}, {"--transfer apic", "impm"}},
             {{"--scheme", "musl", "--support", "2"}, {"--support", "impm", "musl"}},
             {{"--G", "0.32"}, {"--G", "0.32", "0.318"}},
             {{"--G", "0.2", "--mode", "2"}, {"--G", "--mode 2", "0.159"}},
             {{"--nu", "0.5"}, {"--nu", "0.5"}},
             {{"--scheme", "mus"}, {"--scheme", "musl"}},
             {{"--periods", "1", "--t-end", "1"}, {"periods", "t-end"}}}) {
        const Folder folder;
        expect_one_line(folder.run(program, words), 2, parts);
        EXPECT_TRUE(folder.empty());
    }
}

TEST(FemBar, RunsBothFormulationsAndElements) {
    for (const char* formulation : {"total", "updated"})
        for (const char* shape : {"hat", "lagrange"}) {
            const Folder folder;
            const Words words{"--formulation", formulation, "--shape", shape, "--gauss", "3", "--cells", "10", "--periods", "2"};
            const auto table = summary(folder, "fem_bar", words);
            EXPECT_EQ(field(table, 1, "scheme"), std::string("fem-") + formulation);
            EXPECT_EQ(field(table, 1, "particles"), "30");
            EXPECT_LT(std::stod(field(table, 1, "error")), 2e-3);  // of the frequency; linear elements: (beta h)^2/24 = 1e-3
            EXPECT_NEAR(std::stod(field(table, 1, "energy_drift")), 0, 1e-3);
        }
}
TEST(FemBar, RefusesWhatDoesNotGoTogether) {
    const Folder folder;
    expect_one_line(folder.run("fem_bar", {"--shape", "lagrange", "--gauss", "1"}), 2, {"--gauss 1", "lagrange", "2 and 3"});
    expect_one_line(folder.run("fem_bar", {"--gauss", "1", "--ppc", "1"}), 2, {"gauss", "ppc"});
    expect_one_line(folder.run("fem_bar", {"--gauss", "4"}), 2, {"--gauss", "4"});
    expect_one_line(folder.run("fem_bar", {"--alpha", "1"}), 2, {"--alpha"});
    EXPECT_TRUE(folder.empty());
}

}  // namespace
}  // namespace mpm::test
