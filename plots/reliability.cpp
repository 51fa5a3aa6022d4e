/// reliability: every program of the build with random settings, right and wrong, and stopped at a random moment.
///   ./reliability --runs 200
#include <sys/types.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <sstream>

#include "lab/csv_read.hpp"
#include "lab/options.hpp"
#include "lab/program.hpp"
#include "lab/record.hpp"
#include "lab/run.hpp"
#include "plots/process.hpp"
#include "plots/random_options.hpp"
#include "plots/variant.hpp"

namespace {
namespace fs = std::filesystem;
using namespace mpm;

struct Settings {
    int runs = 200, seed = 1;
    double seconds = 1, timeout = 120;
    std::string out = "out/reliability", only, programs;
    bool quiet = false;

    void declare(Options& o) {
        o.integer("runs", runs, "-", at_least(1),
                  "right settings for each program, as many wrong ones, a tenth as many stopped runs, a twentieth on a full disk");
        o.integer("seed", seed, "-", at_least(0), "of the random numbers");
        o.number("seconds", seconds, "s", above(0), "settings for which --dry-run estimates more are not run");
        o.number("timeout", timeout, "s", above(0), "a run that takes longer is a failure");
        o.text("only", only, "programs, by commas; empty: all of the build");
        o.text("out", out, "folder of the results: reliability.csv, and what failed runs wrote");
        o.text("programs", programs, "folder of the programs; empty: that of this one");
        o.flag("quiet", quiet, "say nothing but errors");
    }
};

struct Tried {
    Ending end;
    std::string out, err, files;  // files: the folder that the run wrote to
};

/// One program under test, and where its runs go.
class Trial {
    static constexpr double patience = 2;  // seconds; what takes longer without telling so before is not tried

public:
    Trial(const Settings& s, Programs& programs, const std::string& name)
        : s_(s),
          path_(programs.path(name)),
          folder_(s.out + "/" + name),
          options_(described_options(programs.describe(name))),
          dry_(programs.accepts(name, "dry-run")),
          random_(static_cast<std::uint64_t>(s.seed) + std::hash<std::string>()(name)) {
        make_folder(folder_);
    }

    /// Settings that the program accepts and that it says are short; none after many tries.
    std::optional<Words> right() {
        for (int tries = 0; tries < 50; ++tries) {
            Words words = random_settings(options_, random_);
            if (!dry_) return words;
            words.push_back("--dry-run");
            const Tried asked = run(words, patience);
            words.pop_back();
            if (asked.end.timed_out) continue;                            // it is far from short
            if (asked.end.code == 2 && one_line_of(asked.err)) continue;  // they do not go together
            if (asked.end.code == 0 && asked.end.usable() && estimate(asked.out) > s_.seconds) continue;
            return words;
        }
        return {};
    }
    double limit() const { return dry_ ? s_.timeout : std::min(s_.timeout, patience); }
    /// Programs without --dry-run say only when they run that settings do not go together, and never how long they would take.
    bool may_refuse(const Tried& t) const { return !dry_ && (t.end.timed_out || (t.end.code == 2 && one_line_of(t.err))); }
    Words wrong() { return wrong_settings(options_, random_); }
    double moment() { return std::uniform_real_distribution<double>(0.005, 0.25)(random_); }

    Tried run(Words words, double timeout) { return run(Command{path_, {}}, std::move(words), folder_ + "/run", timeout); }
    /// With no more than 2 kB for each file, which is to a program as a disk that gets full.
    Tried on_a_full_disk(Words words, double timeout) {
        return run(Command{"/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 4; exec \"$0\" \"$@\"", path_}}, std::move(words), folder_ + "/run",
                   timeout);
    }
    /// Into a folder that cannot be made, whoever asks: its parent is a file.
    Tried into_no_folder(Words words, double timeout) { return run(Command{path_, {}}, std::move(words), path_ + "/run", timeout); }
    /// Keeps what a failed run wrote, for a look at it.
    void keep(int number) const {
        if (fs::exists(folder_ + "/run")) fs::rename(folder_ + "/run", folder_ + "/failed-" + std::to_string(number));
    }
    void clean() const {
        for (const char* name : {"/run", "/output", "/errors"}) fs::remove_all(folder_ + name);
        if (fs::is_empty(folder_)) fs::remove(folder_);
    }
    static bool one_line_of(const std::string& text) { return !text.empty() && std::count(text.begin(), text.end(), '\n') == 1; }

    bool accepts(const std::string& name) const {
        return std::any_of(options_.begin(), options_.end(), [&](const DescribedOption& o) { return o.name == name; });
    }

private:
    Tried run(Command command, Words words, const std::string& files, double timeout) {
        Tried t;
        t.files = files;
        if (fs::is_directory(files)) fs::remove_all(files);
        if (accepts("out")) words.insert(words.end(), {"--out", files});
        command.words.insert(command.words.end(), words.begin(), words.end());
        t.end = run_process(command, folder_ + "/output", folder_ + "/errors", timeout);
        t.out = read_file(folder_ + "/output");
        t.err = read_file(folder_ + "/errors");
        return t;
    }

    /// The seconds that --dry-run tells, "about 5 MB and 0.3 s", of all resolutions.
    static double estimate(const std::string& said) {
        static const std::string before = " MB and ";
        double sum = 0;
        for (std::size_t at = said.find(before); at != std::string::npos; at = said.find(before, at + 1))
            sum += std::atof(said.c_str() + at + before.size());
        return sum;
    }

    const Settings& s_;
    std::string path_, folder_;
    std::vector<DescribedOption> options_;
    bool dry_;
    Random random_;
};

/// What is wrong with the CSV files below a folder; "" if nothing. A run that was killed may leave a last row without its end.
std::string unreadable(const std::string& folder) {
    if (!fs::exists(folder)) return "";
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".csv") continue;
        try {
            read_csv(entry.path());
        } catch (const std::exception& trouble) {
            return trouble.what();
        }
    }
    return "";
}

/// What is wrong with a run of right settings: it ends with 0 or 3, says 3 if and only if a row is not ok, and gives a number for each
/// error that it vouches for.
std::string judge(const Tried& t) {
    if (!t.end.trouble().empty()) return t.end.trouble();
    if (const std::string trouble = unreadable(t.files); !trouble.empty()) return trouble;
    if (!fs::exists(t.files + "/summary.csv")) return t.end.code == 3 ? "unstable without a summary" : "";
    const CsvTable summary = read_csv(t.files + "/summary.csv");
    if (summary.rows.empty()) return "summary.csv has no row";
    for (const char* column : {"verdict", "reference", "error", "reason"})
        if (!summary.has(column)) return std::string("summary.csv has no column ") + column;
    bool all_ok = true;
    for (std::size_t row = 0; row < summary.rows.size(); ++row) {
        const bool ok = summary.text(row, "verdict") == "ok";
        all_ok = all_ok && ok;
        if (ok && summary.text(row, "reference") != "none" && std::isinf(summary.number(row, "error"))) return "ok with an infinite error";
        if (!ok && summary.text(row, "reason").empty()) return "unstable without a reason";
    }
    if (all_ok != (t.end.code == 0)) return "verdicts and exit code " + std::to_string(t.end.code) + " do not agree";
    return "";
}

std::string judge_wrong(const Tried& t) {
    if (t.end.signal || t.end.code != 2)
        return "ended with " + (t.end.signal ? t.end.trouble() : "exit " + std::to_string(t.end.code)) + ", not with exit 2";
    if (!Trial::one_line_of(t.err)) return "not one line on stderr";
    return fs::exists(t.files) ? "wrote files" : "";
}

/// Files that cannot be written: exit 1 and a line that says which. Those that all fit are no trouble.
std::string judge_full(const Tried& t) {
    if (t.end.usable()) return unreadable(t.files);
    if (t.end.timed_out || t.end.signal != 0 || t.end.code != 1) return t.end.trouble();
    return Trial::one_line_of(t.err) ? unreadable(t.files) : "not one line on stderr";
}
std::string judge_no_folder(const Tried& t) {
    if (t.end.signal != 0 || t.end.timed_out) return t.end.trouble();
    if (t.end.code != 1) return "ended with exit " + std::to_string(t.end.code) + ", not with exit 1";
    return Trial::one_line_of(t.err) ? "" : "not one line on stderr";
}

class Sweep {
public:
    explicit Sweep(const Settings& s)
        : s_(s), csv_(s.out + "/reliability.csv", {"program", "kind", "words", "exit", "seconds", "result"}) {}

    void program(Programs& programs, const std::string& name) {
        Trial trial(s_, programs, name);
        const int before = failures_, earlier = tried_;
        for (int i = 0, tried = 0; tried < s_.runs && i < 4 * s_.runs && !interrupted(); ++i) {
            const auto words = trial.right();
            if (!words) break;
            const Tried t = trial.run(*words, trial.limit());
            if (trial.may_refuse(t)) continue;
            tell(trial, name, "right", *words, t, judge(t));
            ++tried;
        }
        for (int i = 0; i < s_.runs && !interrupted(); ++i) {
            const Words words = trial.wrong();
            const Tried t = trial.run(words, s_.timeout);
            tell(trial, name, "wrong", words, t, judge_wrong(t));
        }
        for (int i = 0; i < (s_.runs + 9) / 10 && !interrupted(); ++i) {
            const auto words = trial.right();
            if (!words) break;
            const Tried t = trial.run(*words, trial.moment());
            tell(trial, name, "stopped", *words, t, unreadable(t.files));
        }
        for (int i = 0; i < (s_.runs + 19) / 20 && trial.accepts("out") && !interrupted(); ++i) {
            const auto words = trial.right();
            if (!words) break;
            const Tried full = trial.on_a_full_disk(*words, trial.limit()), none = trial.into_no_folder(*words, trial.limit());
            if (trial.may_refuse(none) || trial.may_refuse(full)) continue;
            tell(trial, name, "full disk", *words, full, judge_full(full));
            tell(trial, name, "no folder", *words, none, judge_no_folder(none));
        }
        trial.clean();
        if (!s_.quiet) std::printf("%-24s %d of %d runs failed\n", name.c_str(), failures_ - before, tried_ - earlier), std::fflush(stdout);
    }
    int failures() const { return failures_; }

private:
    void tell(const Trial& trial, const std::string& name, const char* kind, const Words& words, const Tried& t,
              const std::string& failure) {
        if (t.end.stopped) return;
        ++tried_;
        csv_.row({name, kind, joined(words, " "), std::to_string(t.end.code), number_text(t.end.wall_s), failure.empty() ? "ok" : failure});
        if (failure.empty()) return;
        trial.keep(++failures_);
        std::fprintf(stderr, "%s %s: %s\n", name.c_str(), joined(words, " ").c_str(), one_line(failure, 200).c_str());
    }

    const Settings& s_;
    CsvFile csv_;
    int failures_ = 0, tried_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    return guarded("reliability", [&] {
        Options options("reliability", "runs every program with random settings, right and wrong, and stops some of the runs");
        Settings s;
        s.declare(options);
        options.parse(argc, argv);
        if (answered(options, "reliability")) return 0;
        catch_interrupts();
        Programs programs(s.programs);
        Words names;
        std::istringstream only(s.only);
        for (std::string name; std::getline(only, name, ',');) names.push_back(name);
        if (names.empty()) names = programs.names();
        for (const std::string& name : names) programs.path(name);
        make_folder(s.out);
        Sweep sweep(s);
        for (const std::string& name : names) sweep.program(programs, name);
        if (!s.quiet) std::printf("written: %s/reliability.csv\n", s.out.c_str());
        return interrupted() ? 130 : sweep.failures() > 0 ? 3 : 0;
    });
}
