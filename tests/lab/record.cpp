/// CSV files and whole files: exact numbers, quoting, and what happens when writing fails.
#include "lab/record.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "lab/options.hpp"

namespace {

/// A folder that goes away with the test.
struct Folder {
    std::string path = testing::TempDir() + "mpm_record_" + std::to_string(getpid());
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};
std::string content(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}
template <class Action> std::string trouble(Action action) {
    try {
        action();
    } catch (const mpm::FileTrouble& e) {
        return e.what();
    }
    return "";
}

TEST(NumberText, IsShort) {
    EXPECT_EQ(mpm::number_text(0.1), "0.1");
    EXPECT_EQ(mpm::number_text(10), "10");
    EXPECT_EQ(mpm::number_text(-2.5e-7), "-2.5e-07");
}
TEST(NumberText, NamesNanAndInfinity) {
    EXPECT_EQ(mpm::number_text(-std::nan("")), "nan");
    EXPECT_EQ(mpm::number_text(-std::numeric_limits<double>::infinity()), "-inf");
}
TEST(NumberText, ReadsBackExactly) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 10000; ++i) {
        const double x = std::ldexp(std::uniform_real_distribution<>(-1, 1)(random), static_cast<int>(random() % 2000) - 1000);
        EXPECT_EQ(std::strtod(mpm::number_text(x).c_str(), nullptr), x);
    }
}
TEST(CsvField, IsQuotedWhereNeeded) {
    EXPECT_EQ(mpm::csv_field("plain text"), "plain text");
    EXPECT_EQ(mpm::csv_field("a,\"b\"\n"), "\"a,\"\"b\"\"\n\"");
}
TEST(OneLine, EscapesAndCuts) {
    EXPECT_EQ(mpm::one_line("a\n\x01\x7F\tb"), "a\\n\\x01\\x7f\\tb");
    EXPECT_EQ(mpm::one_line("abcdef", 3), "abc...");
    EXPECT_EQ(mpm::one_line("\xC3\xB6\xC3\xB6\xC3\xB6", 2), "\xC3\xB6\xC3\xB6...");
}
TEST(CsvFile, FlushesEachRow) {
    const Folder folder;
    mpm::Csv<2> file(folder.path + "/a.csv", {"t", "x, y"});
    file.row(1, 0.5);
    EXPECT_EQ(content(folder.path + "/a.csv"), "t,\"x, y\"\n1,0.5\n");
    file.row(std::array<double, 2>{2, 1e-9});
    EXPECT_EQ(content(folder.path + "/a.csv"), "t,\"x, y\"\n1,0.5\n2,1e-09\n");
}
TEST(CsvFile, WritesTextRows) {
    const Folder folder;
    mpm::CsvFile file(folder.path + "/a.csv", {"a", "b"});
    file.row({std::string("x"), std::string("y,z")});
    EXPECT_EQ(content(file.path()), "a,b\nx,\"y,z\"\n");
}
TEST(CsvFile, RefusesRowsOfAnotherLength) {
    const Folder folder;
    mpm::CsvFile file(folder.path + "/a.csv", {"a", "b"});
    const double values[3] = {};
    EXPECT_THROW(file.row(values, 3), std::logic_error);
    EXPECT_THROW(file.row(std::vector<std::string>{"x"}), std::logic_error);
}
TEST(CsvFile, SaysThatTheDiskIsFull) {
    EXPECT_EQ(trouble([] { mpm::CsvFile("/dev/full", {"a"}); }), "cannot write '/dev/full': No space left on device");
}
TEST(CsvFile, SaysThatTheFolderIsMissing) {
    EXPECT_EQ(trouble([] { mpm::CsvFile("/no/a.csv", {"a"}); }), "cannot open '/no/a.csv': No such file or directory");
}
TEST(CsvFile, SaysThatALaterRowDoesNotFit) {
    const Folder folder;
    mpm::CsvFile file(folder.path + "/a.csv", {"a"});
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{2, before.rlim_max};  // the header fits, nothing else does
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const double value = 1;
    const std::string message = trouble([&] { file.row(&value, 1); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(message, "cannot write '" + file.path() + "': File too large");
}
TEST(WriteFile, ReplacesTheWhole) {
    const Folder folder;
    mpm::write_file(folder.path + "/a", "long old text");
    mpm::write_file(folder.path + "/a", "new\n");
    EXPECT_EQ(content(folder.path + "/a"), "new\n");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);  // no temporary file is left
}
TEST(WriteFile, SaysWhatFailed) {
    EXPECT_EQ(trouble([] { mpm::write_file("/no/a", ""); }), "cannot write '/no/a': No such file or directory");
    EXPECT_EQ(trouble([] { mpm::write_file("/dev/full", "x"); }), "cannot write '/dev/full': not a regular file");
    EXPECT_EQ(trouble([] { mpm::write_file("/tmp", "x"); }), "cannot write '/tmp': not a regular file");
}

}  // namespace
