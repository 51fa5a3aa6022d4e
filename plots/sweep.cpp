#include "plots/sweep.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <list>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "lab/options.hpp"
#include "lab/program.hpp"
#include "lab/record.hpp"
#include "plots/progress.hpp"

namespace mpm {
namespace {

namespace fs = std::filesystem;
const Words sweep_columns{"variant", "name", "shared", "program", "options", "cells", "folder", "command"};

/// The files of a run's folder: what the program says on stderr, what it was called with, how it ended, what that took.
struct Files {
    std::string folder, summary, errors, command, exit_code, process;
    Files(const std::string& sweep, const Run& run)
        : folder(sweep + "/" + run.folder),
          summary(folder + "/summary.csv"),
          errors(folder + "/stderr.txt"),
          command(folder + "/command.txt"),
          exit_code(folder + "/exit_code"),
          process(folder + "/process.csv") {}
};

/// Empties a folder of what an earlier run left that could be taken for this one's.
void prepare(const Files& files, const Run& run) {
    make_folder(files.folder);
    for (const std::string& path : {files.exit_code, files.process, files.summary, files.errors}) {
        std::error_code error;
        if (fs::remove(path, error); error) throw FileTrouble("cannot remove '" + path + "': " + error.message());
    }
    write_file(files.command, run.text + "\n");
}

/// Keeps how a run ended.
void record(const Files& files, const Ending& end) {
    CsvFile(files.process, {"wall_s", "cpu_s", "peak_rss_kb"})
        .row({number_text(end.wall_s), number_text(end.cpu_s), std::to_string(end.peak_rss_kb)});
    write_file(files.exit_code, (end.timed_out ? "124 timeout" : std::to_string(end.signal != 0 ? 128 + end.signal : end.code)) + "\n");
}

std::optional<int> exit_code(const Files& files) {
    if (!fs::exists(files.exit_code)) return {};
    int code = 0;
    return std::sscanf(read_file(files.exit_code).c_str(), "%d", &code) == 1 ? std::optional<int>(code) : std::nullopt;
}

/// The summary rows, or none and why.
std::vector<SummaryRow> summary(const Files& files, std::string& why) {
    std::vector<SummaryRow> rows;
    if (!fs::exists(files.summary)) return why = "there is no summary.csv", rows;
    try {
        const CsvTable table =
            parse_csv(read_file(files.summary), "summary.csv");  // not its path: rows do not depend on where the sweep is
        if (table.columns != summary_columns()) throw std::invalid_argument("its columns are not those of a summary");
        for (const auto& fields : table.rows) rows.push_back(summary_row(fields));
        if (rows.empty()) why = "summary.csv has no row";
    } catch (const FileTrouble& trouble) {
        why = trouble.what();
    } catch (const std::invalid_argument& trouble) {
        why = "summary.csv: " + std::string(trouble.what());
    }
    return why.empty() ? rows : std::vector<SummaryRow>();
}

/// The last line that a failed program wrote on stderr, not what some shells add when a signal ends a program.
std::string last_words(const Files& files, int code) {
    if (!fs::exists(files.errors)) return "";
    std::istringstream text(read_file(files.errors));
    const std::string by_shell = code > 128 ? strsignal(code - 128) : "\n";
    std::string last;
    for (std::string line; std::getline(text, line);)
        if (!line.empty() && !line.starts_with(by_shell)) last = line;
    return one_line(last, 200);
}

}  // namespace

std::vector<Run> plan_sweep(Programs& programs, const std::vector<Variant>& variants, const std::vector<int>& cells,
                            const std::string& folder) {
    std::string shared;
    const Words names = short_names(variants, shared);
    std::vector<Run> runs;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const Variant& variant = variants[v];
        for (std::size_t other = 0; other < v; ++other)
            if (variants[other].file_name() == variant.file_name()) throw BadInput("the same variant is given twice: " + names[v]);
        if (!programs.accepts(variant.program, "cells"))
            throw BadInput(variant.program + " has no option --cells: it solves nothing on a grid");
        for (const int n : cells) {
            Run run{static_cast<int>(v),
                    names[v],
                    shared,
                    variant.program,
                    variant.options(),
                    "",
                    n,
                    "",
                    {programs.path(variant.program), variant.words}};
            const auto add = [&](const Words& words) { run.command.words.insert(run.command.words.end(), words.begin(), words.end()); };
            add({"--cells", std::to_string(n)});
            if (programs.accepts(variant.program, "plot")) add({"--plot", "none"});
            if (programs.accepts(variant.program, "quiet")) add({"--quiet"});
            run.text = shell_text({variant.program, run.command.words});
            run.folder = "runs/" + variant.file_name() + "/cells-" + std::to_string(n);
            add({"--out", fs::absolute(folder + "/" + run.folder).lexically_normal().string()});
            runs.push_back(run);
        }
    }
    return runs;
}

void write_sweep(const std::string& folder, const std::vector<Run>& runs) {
    CsvFile file(folder + "/sweep.csv", sweep_columns);
    for (const Run& r : runs)
        file.row({std::to_string(r.variant), r.name, r.shared, r.program, r.options, std::to_string(r.cells), r.folder, r.text});
}

std::vector<Run> read_sweep(const std::string& folder) {
    const CsvTable table = read_csv(folder + "/sweep.csv");
    if (table.columns != sweep_columns) throw FileTrouble(folder + "/sweep.csv was not written by compare");
    std::vector<Run> runs;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        runs.push_back({static_cast<int>(table.number(i, "variant")),
                        table.text(i, "name"),
                        table.text(i, "shared"),
                        table.text(i, "program"),
                        table.text(i, "options"),
                        table.text(i, "command"),
                        static_cast<int>(table.number(i, "cells")),
                        table.text(i, "folder"),
                        {}});
    return runs;
}

bool is_complete(const std::string& folder, const Run& run) {
    const Files files(folder, run);
    const auto code = exit_code(files);
    if (!code || !shell_trouble(*code).empty() || !fs::exists(files.command) || read_file(files.command) != run.text + "\n") return false;
    std::string why;
    if (summary(files, why).empty()) return false;
    return fs::last_write_time(run.command.program) <= fs::last_write_time(files.exit_code);
}

bool run_sweep(const std::string& folder, const std::vector<Run>& runs, const RunRules& rules,
               const std::function<void(const Run&)>& after) {
    struct Job {
        const Run* run;
        Files files;
        Process process;
        Job(const Files& where, const Run& r, double timeout)
            : run(&r), files(where), process(r.command, "/dev/null", files.errors, timeout) {}
    };
    std::list<Job> jobs;
    std::vector<const Run*> waiting;
    for (const Run& run : runs)
        if (rules.fresh || !is_complete(folder, run)) waiting.push_back(&run);
    SweepProgress progress(waiting);
    std::size_t next = 0;
    for (Nap nap; next < waiting.size() || !jobs.empty();) {
        if (interrupted()) return false;  // the jobs end with the list
        while (next < waiting.size() && jobs.size() < static_cast<std::size_t>(rules.jobs)) {
            const Run& run = *waiting[next++];
            const Files files(folder, run);
            prepare(files, run);
            jobs.emplace_back(files, run, rules.timeout);
        }
        bool some = false;
        for (auto job = jobs.begin(); job != jobs.end();) {
            const auto end = job->process.look();
            if (!end) {
                ++job;
                continue;
            }
            if (interrupted()) return false;  // Ctrl-C reaches the runs as well: this one has not ended by itself
            some = true;
            record(job->files, *end);
            const Run& run = *job->run;
            job = jobs.erase(job);
            progress.ended(run);
            after(run);
        }
        progress.show(jobs.empty() ? nullptr : jobs.front().run);
        if (some)
            nap.reset();
        else
            nap.sleep();
    }
    return true;
}

std::optional<Outcome> run_one(const std::string& folder, const Run& run, double timeout) {
    const Files files(folder, run);
    prepare(files, run);
    const Ending end = run_process(run.command, "/dev/null", files.errors, timeout);
    if (interrupted()) return {};
    record(files, end);
    return outcome(folder, run);
}

std::vector<std::string> list_sweep(const std::string& folder, const std::vector<Run>& runs, bool fresh) {
    std::vector<std::string> lines;
    for (const Run& run : runs) {
        if (!fresh && is_complete(folder, run)) continue;
        const Files files(folder, run);
        prepare(files, run);
        const auto path = [](const std::string& file) { return shell_text({fs::absolute(file).lexically_normal().string(), {}}); };
        lines.push_back(shell_text(run.command) + " >/dev/null 2>" + path(files.errors) + "; echo $? >" + path(files.exit_code));
    }
    return lines;
}

Outcome outcome(const std::string& folder, const Run& run) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Files files(folder, run);
    const auto code = exit_code(files);
    std::string why, trouble = "failed:not ended";
    std::vector<SummaryRow> rows = summary(files, why);
    if (code) trouble = *code == 124 && read_file(files.exit_code).ends_with("timeout\n") ? "failed:timeout" : shell_trouble(*code);
    if (trouble.empty() && rows.empty()) trouble = "failed:no summary";
    bool all_well = true;
    for (const SummaryRow& row : rows) all_well = all_well && row.verdict == "ok";
    if (trouble.empty() && code == 3 && all_well) trouble = "failed:exit 3";
    if (!trouble.empty() && rows.empty()) {
        SummaryRow row;
        row.program = run.program;
        row.options = run.options;
        row.cells = run.cells;
        row.error_name = row.reference = "none";
        row.h = row.dt = row.cfl = row.t_end = row.wall_s = row.cpu_s = row.ns_per_particle_step = row.energy_drift = row.momentum_drift =
            nan;
        rows.push_back(row);
    }
    const CsvTable process = fs::exists(files.process) ? read_csv(files.process) : CsvTable{};
    for (SummaryRow& row : rows) {
        if (!process.rows.empty()) row.peak_rss_kb = static_cast<long>(process.number(0, "peak_rss_kb"));
        if (trouble.empty()) continue;
        row.error = row.order = row.t_fail = nan;
        row.verdict = trouble;
        row.reason = code == 0 || code == 3 ? why : last_words(files, code.value_or(0));
    }
    return {code.has_value(), rows};
}

}  // namespace mpm
