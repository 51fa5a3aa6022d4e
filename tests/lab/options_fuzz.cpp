/// Thousands of random command lines and config files: each is accepted with every value in its range, or refused in one line.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <random>

#include "lab/options.hpp"

namespace {

using Words = std::vector<std::string>;
std::mt19937 source(20240607);

std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(source); }
bool chance(int percent) { return static_cast<int>(below(100)) < percent; }
const std::string& pick(const Words& words) { return words[below(words.size())]; }

std::string random_bytes(std::size_t most) {
    std::string text(below(most + 1), ' ');
    for (char& c : text) c = static_cast<char>(1 + below(255));  // argv holds no zero byte
    return text;
}
/// One to three letters dropped, doubled, swapped or replaced.
std::string near_miss(std::string word) {
    for (std::size_t n = 1 + below(3); n > 0 && !word.empty(); --n) {
        const std::size_t i = below(word.size());
        switch (below(4)) {
            case 0: word.erase(i, 1); break;
            case 1: word.insert(i, 1, word[i]); break;
            case 2: std::swap(word[i], word[below(word.size())]); break;
            default: word[i] = static_cast<char>(1 + below(255));
        }
    }
    return word;
}

const Words names = {"nu", "dt", "cfl", "mode", "cells", "scheme", "out", "quiet", "help", "version", "describe", "config"};
const Words values = {"0.3",  "-0.5", "1",    "7",     "25,50", "usl",  "musl",  "true", "off",  "",     "1e999", "-1e-999", "nan", "inf",   "0x1",
                      "1x",   "+3",   "+-3",  "1,",    ",",     "--",   "-",     "--nu", "=",    "a=b",  "\"",    "\"a\\",   "#",   "1 # c", "\n",
                      "1\n2", "/tmp", "/no",  "-0",    "0.5",   "1e-3", "2.5",   "1e3",  "on",   "\t",   "\r",    "%s%n",    "--=", "=1",    "2147483648"};

std::string random_name() { return chance(80) ? pick(names) : chance(70) ? near_miss(pick(names)) : random_bytes(12); }
std::string random_value() {
    if (chance(70)) return pick(values);
    if (chance(30)) return std::string(below(400), static_cast<char>('0' + below(10)));  // huge numbers
    if (chance(20)) {
        std::string list = "1";
        for (std::size_t n = below(1100); n > 0; --n) list += ",2";
        return list;
    }
    return chance(50) ? near_miss(pick(values)) : random_bytes(80);
}

/// A program whose values are checked against their ranges.
struct Program {
    double nu = 0.3, dt = 0.1, cfl = 0.5;
    int mode = 1;
    std::vector<int> cells{10};
    std::string scheme = "usl", out = "results";
    bool quiet = false;
    mpm::Options options{"fuzz", "random input"};

    Program() {
        options.number("nu", nu, "-", {.low = -1, .high = 0.5, .low_open = true, .high_open = true}, "");
        options.number("dt", dt, "s", mpm::above(0), "");
        options.number("cfl", cfl, "-", mpm::between(0, 1), "");
        options.integer("mode", mode, "-", mpm::at_least(1), "");
        options.integers("cells", cells, "-", mpm::between(1, 1000), "");
        options.choice("scheme", scheme, {"usl", "usf", "musl"}, "");
        options.text("out", out, "");
        options.flag("quiet", quiet, "");
        options.contradict("dt", "cfl");
    }
    bool untouched() const {
        return nu == 0.3 && dt == 0.1 && cfl == 0.5 && mode == 1 && cells == std::vector<int>{10} && scheme == "usl" && out == "results" && !quiet;
    }
    bool within() const {
        bool good = nu > -1 && nu < 0.5 && dt > 0 && std::isfinite(dt) && cfl >= 0 && cfl <= 1 && mode >= 1;
        for (const int n : cells) good = good && n >= 1 && n <= 1000;
        good = good && !cells.empty() && cells.size() <= 1000 && (scheme == "usl" || scheme == "usf" || scheme == "musl");
        for (const char c : out) good = good && static_cast<unsigned char>(c) >= 0x20;
        return good && !(options.given("dt") && options.given("cfl"));
    }
};

/// Parses once; counts whether the words were accepted.
void try_words(const Words& words, int& accepted) {
    Program p;
    std::vector<const char*> argv = {"fuzz"};
    for (const auto& word : words) argv.push_back(word.c_str());
    std::string message;
    try {
        p.options.parse(static_cast<int>(argv.size()), argv.data());
    } catch (const mpm::BadInput& e) {
        message = e.what();
    } catch (const mpm::FileTrouble& e) {
        message = e.what();
    }  // anything else ends the test
    if (message.empty()) {
        ++accepted;
        EXPECT_TRUE(p.within());
        EXPECT_LE(p.options.label().size(), 80u);
        EXPECT_EQ(p.options.label().find_first_of("/\\ \n\"'"), std::string::npos);
        return;
    }
    EXPECT_TRUE(p.untouched()) << message;
    EXPECT_EQ(message.find_first_of("\n\r\x1b"), std::string::npos) << message;
    EXPECT_LT(message.size(), 700u) << message;
}

/// The config file of this process.
const std::string path = testing::TempDir() + "mpm_fuzz_" + std::to_string(getpid()) + ".ini";
void write(const std::string& text) { std::ofstream(path, std::ios::binary | std::ios::trunc) << text; }

TEST(OptionsFuzz, CommandLines) {
    int accepted = 0;
    for (int round = 0; round < 20000 && !HasFailure(); ++round) {
        Words words;
        for (std::size_t n = below(5); n > 0; --n) {
            const std::string dashes = chance(90) ? "--" : pick({"", "-", "---"}), name = random_name();
            const bool flag = name == "quiet" || name == "help" || name == "version" || name == "describe";
            if (flag && chance(80)) words.push_back(dashes + name);
            else if (chance(50)) words.push_back(dashes + name + "=" + random_value());
            else words.insert(words.end(), {dashes + name, random_value()});
            if (chance(5)) words.push_back(random_bytes(20));
            if (chance(5)) words.push_back(words.front());
        }
        try_words(words, accepted);
    }
    EXPECT_GT(accepted, 1000);
}

TEST(OptionsFuzz, ConfigFiles) {
    int accepted = 0;
    for (int round = 0; round < 10000 && !HasFailure(); ++round) {
        std::string text;
        for (std::size_t n = below(5); n > 0; --n) {
            text += random_name() + pick({"=", " = ", " ", "==", "\t=\t"}) + random_value() + pick({"\n", "\r\n", " # c\n", "\n\n", ""});
            if (chance(3)) text += random_bytes(40);
            if (chance(2)) text += std::string(1, '\0');
        }
        write(text);
        try_words({"--config", path}, accepted);
    }
    EXPECT_GT(accepted, 500);
    std::remove(path.c_str());
}

TEST(OptionsFuzz, SettingsReadBack) {
    const std::string letters = "ab #\"\\;=,'%\xC3\xB6";
    for (int round = 0; round < 2000 && !HasFailure(); ++round) {
        Program p, q;
        p.nu = std::uniform_real_distribution<>(-0.99, 0.49)(source);
        p.dt = std::exp(std::uniform_real_distribution<>(-600, 600)(source));
        p.mode = 1 + static_cast<int>(below(2147483647));
        p.out.assign(below(12), 'a');
        for (char& c : p.out) c = letters[below(letters.size())];
        const std::vector<std::string> words = {"--nu", std::to_string(p.nu), "--out=" + p.out, "--mode=" + std::to_string(p.mode), "--dt=1"};
        std::vector<const char*> argv = {"fuzz"};
        for (const auto& word : words) argv.push_back(word.c_str());
        const double dt = p.dt;
        p.options.parse(static_cast<int>(argv.size()), argv.data());
        p.dt = dt;
        write(p.options.ini());
        const char* again[] = {"fuzz", "--config", path.c_str()};
        q.options.parse(3, again);
        EXPECT_TRUE(q.nu == p.nu && q.dt == p.dt && q.mode == p.mode && q.out == p.out) << p.options.ini();
    }
    std::remove(path.c_str());
}

}  // namespace
