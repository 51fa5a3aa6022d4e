// extremes: how tables are read, and what becomes of their cells.
#include <gtest/gtest.h>

#include <fstream>

#include "lab/options.hpp"
#include "plots/case_table.hpp"
#include "plots/matrix_figure.hpp"
#include "tests/plots/fakes.hpp"

namespace mpm::test {
namespace {

constexpr const char* head =
    "# a comment\n"
    "table small | A title\n"
    "column first\n"
    "column second | in two | --mode 3\n"
    "scene bar | first | good --mode 2   # another\n"
    "scene bar | * | good\n"
    "scene none | first, second | none: it has no contact\n";

TEST(CaseTable, ReadsColumnsScenesAndCases) {
    const auto tables = read_case_tables(std::string(head) + "case fine | 1e3 | bar | --cells 9 | size | 0.1 | one cell | full\n", "t");
    ASSERT_EQ(tables.size(), 1u);
    const CaseTable& table = tables.front();
    EXPECT_EQ(table.title, "A title");
    EXPECT_EQ(table.columns[1].shown, "in two");
    ASSERT_EQ(table.cases.size(), 1u);
    const ExtremeCase& row = table.cases.front();
    EXPECT_EQ(row.bound, 0.1);
    EXPECT_EQ(row.why, "one cell");
    EXPECT_FALSE(row.quick);
    std::string why_not;
    EXPECT_EQ(table.command(row, table.columns[0], why_not), (Words{"good", "--mode", "2", "--cells", "9"}));
    EXPECT_EQ(table.command(row, table.columns[1], why_not), (Words{"good", "--mode", "3", "--cells", "9"}));
    EXPECT_EQ(why_not, "");
}
TEST(CaseTable, SaysWhyAColumnHasNoSuchScene) {
    const auto tables = read_case_tables(std::string(head) + "case touch | 1 | none | | size | 0.1 | one cell\n", "t");
    std::string why_not;
    EXPECT_TRUE(tables[0].command(tables[0].cases[0], tables[0].columns[1], why_not).empty());
    EXPECT_EQ(why_not, "it has no contact");
}
TEST(CaseTable, RefusesWhatItCannotRead) {
    for (const auto& [line, part] : std::vector<std::pair<std::string, std::string>>{
             {"row a | b", "unknown word row"},
             {"case a | 1 | nowhere | | size | 1 | why", "no scene nowhere"},
             {"case a | 1 | bar | | size | much | why", "'much' is no number"},
             {"case a | 1 | bar | | size | 1", "needs a field 7"},
             {"case a | 1 | bar | | size", "needs a field 6"},
             {"scene bar | third | good", "no column third"}}) {
        try {
            read_case_tables(std::string(head) + line + "\n", "t");
            ADD_FAILURE() << line;
        } catch (const BadInput& bad) {
            EXPECT_TRUE(holds(bad.what(), part)) << bad.what();
            EXPECT_TRUE(holds(bad.what(), "t, line 8")) << bad.what();
        }
    }
}

TEST(Footnotes, GiveOneLetterToEachReason) {
    Footnotes notes;
    EXPECT_EQ(notes.letter("x"), "a");
    EXPECT_EQ(notes.letter("y"), "b");
    EXPECT_EQ(notes.letter("x"), "a");
}

/// Runs a table with the fakes and gives the kinds of its cells, by case and column.
struct Made {
    Fakes fakes;
    Ending ending;
    std::map<std::string, std::string> kinds, reasons;

    explicit Made(const std::string& lines, const Words& more = {}) {
        std::ofstream(fakes.path("table.txt")) << lines;
        make(more);
    }
    void make(const Words& more = {}) {
        Words words{"--table", "table.txt", "--out", "all"};
        words.insert(words.end(), more.begin(), more.end());
        ending = fakes.tool("extremes", words);
        const auto table = csv(fakes.read("all/extremes.csv"));
        for (std::size_t i = 1; i < table.size(); ++i) {
            const std::string cell = field(table, i, "case") + " " + field(table, i, "column");
            kinds[cell] = field(table, i, "kind"), reasons[cell] = field(table, i, "reason");
        }
    }
};

const std::string columns =
    "table t | T\ncolumn good\ncolumn unstable\ncolumn crashes\ncolumn left\n"
    "scene s | good | good\nscene s | unstable | unstable\nscene s | crashes | crashes\nscene s | left | none: a reason\n";

TEST(Extremes, EachCellIsAnErrorAnInstabilityAReasonOrAFailure) {
    const Made made(columns + "case fine | 200 | s | --cells 200 | size | 1e-4 | second order\n");
    EXPECT_EQ(made.kinds.at("fine good"), "error");
    EXPECT_EQ(made.kinds.at("fine unstable"), "unstable");
    EXPECT_EQ(made.kinds.at("fine crashes"), "failed");
    EXPECT_EQ(made.kinds.at("fine left"), "none");
    EXPECT_EQ(made.reasons.at("fine left"), "a reason");
    EXPECT_EQ(made.ending.code, 3);  // the crash
    EXPECT_TRUE(holds(made.ending.out, "1 cells to look into")) << made.ending.out;
}
TEST(Extremes, AnErrorOverItsBoundIsNotOk) {
    const Made made("table t | T\ncolumn good\nscene s | * | good\ncase fine | 10 | s | --cells 10 | size | 1e-3 | third order\n");
    EXPECT_EQ(made.kinds.at("fine good"), "inaccurate");  // 1e-2
    EXPECT_EQ(made.ending.code, 3);
    EXPECT_TRUE(holds(made.ending.out, "allowed 0.001 (third order)")) << made.ending.out;
}
TEST(Extremes, AKnownCauseIsSaidBesideIt) {
    const Made made(
        "table t | T\ncolumn good\nscene s | * | good\ncase fine | 10 | s | --cells 10 | size | 1e-3 | third order\n"
        "known fine | * | good | it is of second order\n");
    EXPECT_EQ(made.kinds.at("fine good"), "inaccurate");
    EXPECT_EQ(made.reasons.at("fine good"), "it is of second order");
    EXPECT_EQ(made.ending.code, 0);
    EXPECT_TRUE(holds(made.ending.out, "1.0e-2 (a)!")) << made.ending.out;
}
TEST(Extremes, WhatAProgramDoesNotOfferIsItsOwnReason) {
    const Made made("table t | T\ncolumn good\nscene s | * | good\ncase fine | 10 | s | --power 3 | size | 1 | why\n");
    EXPECT_EQ(made.kinds.at("fine good"), "none");
    EXPECT_TRUE(holds(made.reasons.at("fine good"), "unknown option --power")) << made.reasons.at("fine good");
    EXPECT_EQ(made.ending.code, 0);
}
TEST(Extremes, JustBelowTheLargestStepIsStableAndJustBeyondIsNamed) {
    const Made made(
        "table t | T\ncolumn limited\nscene s | * | limited\nlimit step | - | s | --cells 10\n"
        "step below | .99 | s | --cells 10 | size | 1 | any | 0.99\nstep beyond | 1.01 | s | --cells 10 | size | 1 | any | 1.01\n");
    EXPECT_EQ(made.kinds.at("step limited"), "limit");
    EXPECT_EQ(made.kinds.at("below limited"), "error");
    EXPECT_EQ(made.kinds.at("beyond limited"), "unstable");
    EXPECT_EQ(made.ending.code, 0) << made.ending.out;
}
TEST(Extremes, GoesOnWhereItWasStopped) {
    Made made("table t | T\ncolumn good\nscene s | * | good\ncase a | 10 | s | --cells 10 | size | 1 | why\n"
              "limit b | - | s | --cells 10\n");
    const int runs = made.fakes.runs();
    EXPECT_GT(runs, 2);
    made.make();
    EXPECT_EQ(made.fakes.runs(), runs);
    EXPECT_EQ(made.kinds.at("a good"), "error");
}
TEST(Extremes, LeavesOutFullCasesIfQuick) {
    const Made made("table t | T\ncolumn good\nscene s | * | good\ncase a | 10 | s | --cells 10 | size | 1 | why | full\n", {"--quick"});
    EXPECT_TRUE(made.kinds.empty());
}
TEST(Extremes, DrawsItsFigure) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not installed";
    const Fakes fakes;
    std::ofstream(fakes.path("table.txt")) << columns + "case fine | 2^-8 | s | --cells 200 | size | 1e-4 | second order\n";
    const Ending ending = fakes.run("extremes", {"--programs", "bin", "--table", "table.txt", "--out", "all"});
    EXPECT_EQ(ending.err, "");
    for (const char* end : {".csv", ".gp", ".png"}) EXPECT_TRUE(fakes.has(std::string("all/t") + end)) << end;
}

}  // namespace
}  // namespace mpm::test
