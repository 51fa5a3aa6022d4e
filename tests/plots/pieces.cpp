// The parts of compare and stability by themselves: names, orders, bisection, processes.
#include <gtest/gtest.h>

#include <cmath>

#include "plots/bisection.hpp"
#include "plots/script.hpp"
#include "plots/stability_cases.hpp"
#include "plots/stack.hpp"

namespace mpm {
namespace {

TEST(FittedOrder, OfAPowerIsItsExponent) { EXPECT_NEAR(fitted_order({{1, 3}, {0.5, 0.75}, {0.25, 0.1875}}), 2, 1e-12); }
TEST(FittedOrder, IsTheLeastSquaresSlope) {
    // log2: points (0, 0), (1, 1), (2, 4); slope = sum (x - 1)(y - 5/3) / sum (x - 1)^2 = 4/2
    EXPECT_NEAR(fitted_order({{1, 1}, {2, 2}, {4, 16}}), 2, 1e-12);
}
TEST(FittedOrder, NeedsTwoResolutions) {
    EXPECT_TRUE(std::isnan(fitted_order({})));
    EXPECT_TRUE(std::isnan(fitted_order({{1, 1}})));
    EXPECT_TRUE(std::isnan(fitted_order({{1, 1}, {1, 2}})));
}
TEST(Series, FitsOnlyRunsThatEndedWell) {
    Series s;
    s.results = {{10, 0.1, 1e-2, 0, 1, 0, "ok", "", "", ""},
                 {20, 0.05, 2.5e-3, 0, 2, 0, "ok", "", "", ""},
                 {40, 0.025, 1e-9, 0, 3, 0, "unstable:x", "", "", ""}};
    EXPECT_NEAR(s.order(), 2, 1e-12);
    EXPECT_EQ(s.reached(1e-2)->cells, 10);
    EXPECT_EQ(s.reached(3e-3)->cells, 20);
    EXPECT_EQ(s.reached(1e-3), nullptr);
}
TEST(Series, LevelsOfOneRunAreSaidTogether) {
    Series s{"a", {{10, 0.1, 1e-4, 0, 1, 0, "ok", "", "", ""}, {20, 0.05, 1e-5, 0, 2, 0, "ok", "", "", ""}}};
    EXPECT_EQ(reached_lines({s}), "a reached 1 % ... 1e-4 in 1 s (10 cells), 1e-5 in 2 s (20 cells)\n");
    s.results[0].error = 0.1;
    s.results[1].error = 0.02;
    EXPECT_EQ(reached_lines({s}), "a did not reach 1 %\n");
}
TEST(Series, ReachedIsTheFastest) {
    Series s;
    s.results = {{10, 0.1, 1e-3, 0, 5, 0, "ok", "", "", ""}, {20, 0.05, 2e-3, 0, 2, 0, "ok", "", "", ""}};
    EXPECT_EQ(s.reached(1e-2)->cells, 20);
}

Variant variant(const std::string& program, const std::vector<std::pair<std::string, std::string>>& settings) {
    return {program, {}, settings};
}

TEST(Names, LeaveOutWhatIsShared) {
    std::string shared;
    EXPECT_EQ(short_names({variant("a", {{"mode", "1"}}), variant("b", {{"mode", "1"}, {"shape", "cubic"}})}, shared),
              (Words{"a", "b, cubic"}));
    EXPECT_EQ(shared, "mode = 1");
}
TEST(Names, TakeADefaultForGiven) {
    std::string shared;
    Variant silent = variant("b", {});
    silent.defaults["mode"] = "1";
    EXPECT_EQ(short_names({silent, variant("a", {{"mode", "1"}})}, shared), (Words{"b", "a"}));
    EXPECT_EQ(shared, "mode = 1");
}
TEST(Names, KeepAllOfASingleVariant) {
    std::string shared;
    EXPECT_EQ(short_names({variant("a", {{"mode", "1"}})}, shared), (Words{"a, mode = 1"}));
    EXPECT_EQ(shared, "");
}
TEST(Names, ThatAreCutStayApart) {
    std::string shared;
    const std::string text(80, 'x');
    const Words names = short_names({variant("a", {{"label", text + "1"}}), variant("a", {{"label", text + "2"}})}, shared);
    EXPECT_LT(names[0].size(), 60u);
    EXPECT_NE(names[0], names[1]);
}
TEST(FileSafe, KeepsTextsApart) {
    EXPECT_EQ(file_safe("a_mode-1"), "a_mode-1");
    EXPECT_NE(file_safe("a/b"), file_safe("a:b"));
    EXPECT_EQ(file_safe("a/b").find('/'), std::string::npos);
    EXPECT_NE(file_safe(std::string(100, 'x') + "1"), file_safe(std::string(100, 'x') + "2"));
    EXPECT_LE(file_safe(std::string(100, 'x')).size(), 60u);
}
TEST(SplitVariants, AtDoubleDashes) {
    const char* argv[] = {"compare", "--cells", "10", "--", "a", "--mode", "1", "--", "--", "b"};
    const auto [own, variants] = split_variants(10, argv);
    EXPECT_EQ(own, (Words{"compare", "--cells", "10"}));
    EXPECT_EQ(variants, (std::vector<Words>{{"a", "--mode", "1"}, {}, {"b"}}));
}
TEST(ShellText, QuotesWhatAShellWouldRead) {
    EXPECT_EQ(shell_text({"./a", {"--mode", "1", "b c", "it's", "", "$x"}}), "./a --mode 1 'b c' 'it'\\''s' '' '$x'");
}

Trial trial_with_limit(double fraction, double limit) { return {fraction, 0, fraction <= limit ? "ok" : "unstable:energy-growth", ""}; }

TEST(Bisection, FindsAKnownLimit) {
    for (const double known : {0.001, 0.72, 1.0, 1.98, 40.0}) {
        const auto limit = largest_stable(1, 1e-4, 64, 0.01, [&](double f) { return std::optional(trial_with_limit(f, known)); });
        ASSERT_TRUE(limit && limit->stable && limit->unstable) << known;
        EXPECT_LE(limit->stable->fraction, known);
        EXPECT_GT(limit->stable->fraction, known / 1.01);
        EXPECT_GT(limit->unstable->fraction, known);
        EXPECT_LT(limit->runs, 25);
    }
}
TEST(Bisection, SaysWhenThereIsNoLimit) {
    const auto always = largest_stable(1, 1e-4, 64, 0.01, [&](double f) { return std::optional(trial_with_limit(f, 1e9)); });
    EXPECT_EQ(always->stable->fraction, 64);
    EXPECT_FALSE(always->unstable);
    const auto never = largest_stable(1, 1e-4, 64, 0.01, [&](double f) { return std::optional(trial_with_limit(f, 0)); });
    EXPECT_FALSE(never->stable);
    EXPECT_TRUE(never->unstable);
}
TEST(Bisection, StopsWhenInterrupted) {
    int runs = 0;
    EXPECT_FALSE(
        largest_stable(1, 1e-4, 64, 0.01, [&](double f) { return ++runs < 3 ? std::optional(trial_with_limit(f, 9)) : std::nullopt; }));
    EXPECT_EQ(runs, 3);
}

TEST(Process, SaysHowItEnded) {
    EXPECT_EQ(run_process({"/bin/sh", {"-c", "exit 3"}}, "/dev/null", "/dev/null", 0).trouble(), "");
    EXPECT_EQ(run_process({"/bin/sh", {"-c", "exit 5"}}, "/dev/null", "/dev/null", 0).trouble(), "failed:exit 5");
    EXPECT_EQ(run_process({"/bin/sh", {"-c", "kill -9 $$"}}, "/dev/null", "/dev/null", 0).trouble(), "failed:signal 9");
    EXPECT_EQ(run_process({"/bin/sleep", {"60"}}, "/dev/null", "/dev/null", 0.1).trouble(), "failed:timeout");
    EXPECT_EQ(run_process({"/no/such/program", {}}, "/dev/null", "/dev/null", 0).trouble(), "failed:exit 127");
}
TEST(Process, IsMeasuredByItsOwnMemory) {
    const auto peak = [](const char* count) {
        return run_process({"/usr/bin/awk", {"-v", std::string("n=") + count, "BEGIN { for (i = 0; i < n; ++i) a[i] = i }"}}, "/dev/null",
                           "/dev/null", 0)
            .peak_rss_kb;
    };
    EXPECT_GT(peak("1000000"), peak("1") + 20000);
}
TEST(Script, KeepsPlainTextsPlain) {
    EXPECT_EQ(plain("usl bar's"), "'usl bar''s'");
    EXPECT_EQ(plain("usl_bar"), "'usl\\_bar'");
    EXPECT_EQ(plain("a~b"), "(tex ? 'a~b' : 'a\\~b')");
}
TEST(Script, PutsTicsAtOneTwoFive) { EXPECT_NE(log_axis('x', 0.01, 0.1).find("'0.02' 0.02, '0.05' 0.05, '0.1' 0.1"), std::string::npos); }
TEST(Found, IsShownShort) {
    Found f;
    f.verdict = "ok";
    f.error = 1.94e-4;
    EXPECT_EQ(f.shown(), "1.9e-4");
    f.verdict = "unstable:energy-growth";
    EXPECT_EQ(f.shown(), "energy-growth");
}

}  // namespace
}  // namespace mpm
