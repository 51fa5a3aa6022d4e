/// The rules of the command line and the config file, one idea a test.
#include "lab/options.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace {

using mpm::BadInput, mpm::FileTrouble;
using Words = std::vector<std::string>;

/// A program with one option of each kind.
struct Program {
    double nu = 0.3, dt = 0.1, cfl = 0.5;
    int mode = 1;
    std::vector<int> cells{10};
    std::string scheme = "usl", out = "results";
    bool quiet = false;
    mpm::Options options{"bar", "a vibrating bar"};

    Program() {
        options.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "Poisson's ratio");
        options.number("dt", dt, "s", mpm::above(0), "time step");
        options.number("cfl", cfl, "-", mpm::between(0, 1), "share of the critical time step");
        options.integer("mode", mode, "-", mpm::at_least(1), "mode number");
        options.integers("cells", cells, "-", mpm::at_least(1), "cells, one run each");
        options.choice("scheme", scheme, {"usl", "usf", "musl"}, "order of the steps");
        options.text("out", out, "folder, \"new\" or old");
        options.flag("quiet", quiet, "print nothing");
        options.contradict("dt", "cfl");
        options.unlabelled("quiet");
    }
    void run(Words words) {
        words.insert(words.begin(), "bar");
        std::vector<const char*> argv;
        for (const auto& word : words) argv.push_back(word.c_str());
        options.parse(static_cast<int>(argv.size()), argv.data());
    }
    /// The message of a refusal, or "" if the words are accepted.
    std::string refusal(const Words& words) {
        try {
            run(words);
        } catch (const BadInput& e) {
            return e.what();
        } catch (const FileTrouble& e) {
            return std::string("file: ") + e.what();
        }
        return "";
    }
};

std::string refusal(const Words& words) { return Program().refusal(words); }
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A config file that goes away with the test.
struct Config {
    std::string path = testing::TempDir() + "mpm_options_" + std::to_string(getpid()) + ".ini";
    explicit Config(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
    ~Config() { std::remove(path.c_str()); }
};
std::string config_refusal(const std::string& text) {
    const Config config(text);
    std::string message = refusal({"--config", config.path});
    const std::size_t at = message.find(config.path);
    return at == std::string::npos ? message : message.replace(at, config.path.size(), "FILE");
}

TEST(Options, AreDefaultsWhenNothingIsGiven) {
    Program p;
    p.run({});
    EXPECT_EQ(p.mode, 1);
    EXPECT_FALSE(p.options.given("mode"));
}
TEST(Options, WorkWithoutAnyArgv) {
    Program p;
    EXPECT_NO_THROW(p.options.parse(0, nullptr));
}
TEST(Options, TakeValueAfterSpaceOrEquals) {
    Program p;
    p.run({"--nu", "-0.5", "--mode=7", "--cells", "25,50,100", "--scheme=musl", "--out", "a b=c", "--quiet"});
    EXPECT_EQ(p.nu, -0.5);
    EXPECT_EQ(p.mode, 7);
    EXPECT_EQ(p.cells, (std::vector<int>{25, 50, 100}));
    EXPECT_EQ(p.scheme, "musl");
    EXPECT_EQ(p.out, "a b=c");
    EXPECT_TRUE(p.quiet);
    EXPECT_TRUE(p.options.given("mode"));
}
TEST(Options, SuggestTheNearestName) { EXPECT_EQ(refusal({"--mdoe", "3"}), "unknown option --mdoe (did you mean --mode?)"); }
TEST(Options, SuggestNothingForAFarName) { EXPECT_EQ(refusal({"--zzzzzz"}), "unknown option --zzzzzz (--help lists them)"); }
TEST(Options, AreNotGuessedFromAbbreviations) { EXPECT_EQ(refusal({"--mod=3"}), "unknown option --mod (did you mean --mode?)"); }
TEST(Options, HaveNoShortForm) { EXPECT_EQ(refusal({"-mode", "3"}), "unknown option -mode (did you mean --mode?)"); }
TEST(Options, RefuseRepeats) { EXPECT_EQ(refusal({"--mode=3", "--mode", "3"}), "--mode is given twice"); }
TEST(Options, RefuseRepeatedFlags) { EXPECT_EQ(refusal({"--quiet", "--quiet"}), "--quiet is given twice"); }
TEST(Options, RefuseLooseWords) { EXPECT_EQ(refusal({"7"}), "unexpected word '7': options are given as --name value"); }
TEST(Options, RefuseWordsAfterTwoDashes) { EXPECT_TRUE(holds(refusal({"--", "--mode"}), "unexpected word")); }
TEST(Options, RefuseAMissingValueAtTheEnd) { EXPECT_EQ(refusal({"--mode"}), "--mode needs a value"); }
TEST(Options, DoNotTakeTheNextOptionForAValue) { EXPECT_EQ(refusal({"--out", "--quiet"}), "--out needs a value"); }
TEST(Options, FlagsTakeNoValueOnTheCommandLine) {
    EXPECT_EQ(refusal({"--quiet=true"}), "--quiet takes no value");
    EXPECT_EQ(refusal({"--quiet="}), "--quiet takes no value");
    EXPECT_TRUE(holds(refusal({"--quiet", "true"}), "unexpected word 'true'"));
}
TEST(Options, NameValueRangeAndDefault) {
    EXPECT_EQ(refusal({"--nu", "0.7"}), "--nu = 0.7: allowed -1 ... 0.5 (ends excluded), default 0.3");
    EXPECT_EQ(refusal({"--dt=0"}), "--dt = 0: allowed > 0, default 0.1");
    EXPECT_EQ(refusal({"--mode=0"}), "--mode = 0: allowed whole numbers >= 1, default 1");
}
TEST(Options, KeepOpenEndsOut) {
    EXPECT_NE(refusal({"--nu=0.5"}), "");
    EXPECT_NE(refusal({"--nu=-1"}), "");
    EXPECT_EQ(refusal({"--cfl=1"}), "");
    EXPECT_EQ(refusal({"--cfl=0"}), "");
}
TEST(Options, AcceptNumbersOfEveryCommonForm) {
    for (const char* text : {"+0.001", "1e-3", "1E-3", ".001", "0.001"}) {
        Program p;
        EXPECT_EQ(p.refusal({"--dt", text}), "") << text;
        EXPECT_EQ(p.dt, 0.001) << text;
    }
}
TEST(Options, ReadNumbersWhole) {
    for (const char* text : {"1x", "", " 1", "1 ", "nan", "inf", "-inf", "+", "+-1", "++1", "0x10", "1e999", "1e-999", "1,5", "1.5.2"})
        EXPECT_TRUE(holds(refusal({"--dt", text}), "--dt = ")) << text;
}
TEST(Options, ReadIntegersWholeAndWithinInt) {
    for (const char* text : {"2.5", "1e3", "2147483648", "99999999999999999999", "", "0x1", "1x"})
        EXPECT_TRUE(holds(refusal({"--mode", text}), "--mode = ")) << text;
    EXPECT_EQ(refusal({"--mode", "+2147483647"}), "");
}
TEST(Options, RefuseListsWithBadItems) {
    for (const char* text : {"", ",", "1,", ",1", "1,,2", "1,x", "0,1", "1;2", "1, 2", "1.5"})
        EXPECT_TRUE(holds(refusal({"--cells", text}), "--cells = ")) << text;
}
TEST(Options, LimitListsToAThousandItems) {
    std::string list = "1";
    for (int i = 1; i < 1000; ++i) list += ",1";
    EXPECT_EQ(refusal({"--cells", list}), "");
    EXPECT_TRUE(holds(refusal({"--cells", list + ",1"}), "1 to 1000 whole numbers"));
}
TEST(Options, NameAllChoicesAndTheNearest) {
    EXPECT_EQ(refusal({"--scheme=msul"}), "--scheme = msul: allowed usl, usf, musl (did you mean musl?), default usl");
    EXPECT_NE(refusal({"--scheme=USL"}), "");
}
TEST(Options, AcceptAnEmptyText) {
    Program p;
    p.run({"--out="});
    EXPECT_EQ(p.out, "");
}
TEST(Options, RefuseControlCharactersInText) { EXPECT_TRUE(holds(refusal({"--out", "a\nb"}), "--out = a\\nb: allowed text")); }
TEST(Options, EscapeAndCutForeignTextInMessages) {
    const std::string message = refusal({"--mode", "1\n\033[31m" + std::string(5000, 'x')});
    EXPECT_TRUE(holds(message, "--mode = 1\\n\\x1b[31mxxx"));
    EXPECT_LT(message.size(), 150u);
    EXPECT_EQ(message.find('\n'), std::string::npos);
}
TEST(Options, EscapeUnknownNames) { EXPECT_TRUE(holds(refusal({"--a\nb"}), "unknown option --a\\nb")); }
TEST(Options, RefuseContradictions) {
    EXPECT_EQ(refusal({"--dt=1", "--cfl=0.5"}), "--dt and --cfl cannot be given together");
    EXPECT_EQ(refusal({"--dt=1"}), "");
}
TEST(Options, LeaveEverythingAloneAfterAFailure) {
    for (const Words& words : {Words{"--mode=9", "--quiet", "--nu=9"}, Words{"--mode=9", "--dt=1", "--cfl=1"}, Words{"--mode=9", "--config=/no"}}) {
        Program p;
        EXPECT_NE(p.refusal(words), "");
        EXPECT_EQ(p.mode, 1);
        EXPECT_EQ(p.dt, 0.1);
        EXPECT_FALSE(p.quiet);
        EXPECT_FALSE(p.options.given("mode"));
    }
}
TEST(Options, KnowWhatIsAsked) {
    Program p;
    p.run({"--help", "--describe"});
    EXPECT_TRUE(p.options.asked("help") && p.options.asked("describe"));
    EXPECT_FALSE(p.options.asked("version"));
}
TEST(Options, RefuseProgramMistakes) {
    mpm::Options o("p", "");
    int i = 5;
    EXPECT_THROW(o.integer("help", i, "-", mpm::any(), ""), std::logic_error);
    EXPECT_THROW(o.integer("i", i, "-", mpm::between(0, 1), ""), std::logic_error);
    EXPECT_THROW(o.unlabelled("none"), std::logic_error);
}

TEST(Config, ReadsNamesCommentsAndBlanks) {
    const Config config("\xEF\xBB\xBF# a case\r\n\n  mode = 4 # four\nquiet=on\r\nout = \"a # \\\"b\\\"\" # c\ncells=1,2");
    Program p;
    p.run({"--config", config.path});
    EXPECT_EQ(p.mode, 4);
    EXPECT_TRUE(p.quiet);
    EXPECT_EQ(p.out, "a # \"b\"");
    EXPECT_EQ(p.cells, (std::vector<int>{1, 2}));
    EXPECT_TRUE(p.options.given("mode"));
}
TEST(Config, YieldsToTheCommandLine) {
    const Config config("mode = 4\ndt = 2");
    Program p;
    p.run({"--mode=5", "--config=" + config.path});
    EXPECT_EQ(p.mode, 5);
    EXPECT_EQ(p.dt, 2);
}
TEST(Config, ReadsFlagsInSixWords) {
    for (const char* text : {"true", "1", "on", "false", "0", "off"}) EXPECT_EQ(config_refusal(std::string("quiet = ") + text), "");
    EXPECT_EQ(config_refusal("quiet = yes"), "FILE:1: quiet = yes: allowed true, false, on, off, 1, 0, default false");
}
TEST(Config, NamesFileAndLine) {
    EXPECT_EQ(config_refusal("\nmode = 0"), "FILE:2: mode = 0: allowed whole numbers >= 1, default 1");
    EXPECT_EQ(config_refusal("# x\nmdoe = 0"), "FILE:2: unknown option mdoe (did you mean mode?)");
    EXPECT_EQ(config_refusal("mode 3"), "FILE:1: expected name = value, found mode 3");
    EXPECT_EQ(config_refusal("out = \"a"), "FILE:1: a quote is not closed in \"a");
}
TEST(Config, RefusesRepeats) { EXPECT_EQ(config_refusal("mode=1\n\nmode=1"), "FILE:3: mode is given twice, first in line 1"); }
TEST(Config, RefusesConfigAndHelpInside) { EXPECT_EQ(config_refusal("config = x"), "FILE:1: config belongs on the command line"); }
TEST(Config, RefusesContradictions) { EXPECT_EQ(config_refusal("dt=1\ncfl=1"), "--dt and --cfl cannot be given together"); }
TEST(Config, MustBeReadable) {
    EXPECT_EQ(refusal({"--config", "/no/such"}), "file: cannot read config file '/no/such': No such file or directory");
}
TEST(Config, IsNotADirectory) { EXPECT_EQ(refusal({"--config=/tmp"}), "file: cannot read config file '/tmp': it is a directory"); }
TEST(Config, IsNotBinary) { EXPECT_TRUE(holds(config_refusal(std::string("mode=1\0", 7)), "it is not a text file")); }
TEST(Config, IsSmall) {
    EXPECT_TRUE(holds(config_refusal(std::string(1'000'001, '#')), "it is larger than 1 MB"));
    EXPECT_EQ(config_refusal(std::string(1'000'000, '#')), "");
    EXPECT_TRUE(holds(refusal({"--config=/dev/zero"}), "it is larger than 1 MB"));
}

TEST(Label, IsDefaultWhenNothingDiffers) {
    Program p;
    p.run({"--mode=1", "--quiet"});
    EXPECT_EQ(p.options.label(), "default");
    EXPECT_EQ(p.options.changed(), "");
}
TEST(Label, FollowsTheDeclaration) {
    Program p;
    p.run({"--cells=25,50", "--mode=10", "--cfl=0.2"});
    EXPECT_EQ(p.options.label(), "cfl-0.2_mode-10_cells-25-50");
    EXPECT_EQ(p.options.changed(), "cfl=0.2;mode=10;cells=25,50");
}
TEST(Label, IsSafeAsAFileName) {
    Program p, q;
    p.run({"--out=../a b\xC3\xB6"});
    q.run({"--out=..-a b\xC3\xB6"});
    EXPECT_EQ(p.options.label().find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._+-"), std::string::npos);
    EXPECT_NE(p.options.label(), q.options.label());
}
TEST(Label, IsCutWithAHash) {
    Program p, q;
    p.run({"--out=" + std::string(300, 'a')});
    q.run({"--out=" + std::string(301, 'a')});
    EXPECT_EQ(p.options.label().size(), 80u);
    EXPECT_NE(p.options.label(), q.options.label());
}

TEST(Ini, ReadsBackTheSame) {
    for (const Words& words : {Words{}, Words{"--dt=0.30000000000000004", "--quiet", "--out= a\\#\"b ", "--cells=3,4", "--scheme=usf"},
                               Words{"--cfl=1e-5", "--nu=-0.1", "--out=", "--mode=12"}}) {
        Program p, q;
        p.run(words);
        const Config config(p.options.ini());
        q.run({"--config", config.path});
        EXPECT_EQ(q.options.ini(), p.options.ini());
        EXPECT_EQ(q.options.changed(), p.options.changed());
        EXPECT_TRUE(q.dt == p.dt && q.cfl == p.cfl && q.out == p.out && q.quiet == p.quiet && q.cells == p.cells);
    }
}
TEST(Ini, NamesTheProgram) { EXPECT_EQ(Program().options.ini().rfind("# bar: a vibrating bar\n", 0), 0u); }

TEST(Help, HasALineForEachOption) {
    const std::string help = Program().options.help();
    EXPECT_TRUE(holds(help, "time step [s]; > 0; default 0.1\n"));
    for (const char* name : {"--nu", "--quiet", "--help", "--version", "--describe", "--config"}) EXPECT_TRUE(holds(help, std::string("  ") + name));
}
TEST(Describe, IsCsv) {
    const std::string csv = Program().options.describe();
    EXPECT_EQ(csv.rfind("name,type,default,unit,low,high,choices,help\nnu,number,0.3,-,-1,0.5,,Poisson's ratio\n", 0), 0u);
    EXPECT_TRUE(holds(csv, "\nscheme,choice,usl,-,,,usl|usf|musl,order of the steps\nout,text,results,-,,,,\"folder, \"\"new\"\" or old\"\n"));
}

TEST(Range, SaysWhatItHolds) {
    EXPECT_EQ(mpm::any().text(), "any number");
    EXPECT_EQ(mpm::above(0).text(), "> 0");
    EXPECT_EQ(mpm::at_least(2).text(), ">= 2");
    EXPECT_EQ(mpm::between(0, 1).text(), "0 ... 1");
}
TEST(Range, NeverHoldsNanOrInfinity) {
    EXPECT_FALSE(mpm::any().contains(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(mpm::any().contains(std::numeric_limits<double>::infinity()));
}
TEST(Nearest, IsEmptyWhenNothingIsNear) {
    EXPECT_EQ(mpm::nearest("mdoe", {"cells", "mode"}), "mode");
    EXPECT_EQ(mpm::nearest("x", {"cells", "mode", "y"}), "");
    EXPECT_EQ(mpm::nearest("", {"a"}), "");
}

}  // namespace
