#include "plots/extreme_cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Cell not_offered(const std::string& why) { return {"none", "", "", why, nan, nan, 0}; }

/// What a run came to against the bound.
Cell judged(const Found& found, double bound, double seconds) {
    Cell cell{"error", found.error_name, found.verdict, found.reason, found.error, bound, seconds};
    if (found.verdict == "failed:exit 2") {  // the program's own line, without its name
        const std::size_t colon = found.reason.find(": ");
        return not_offered(colon == std::string::npos ? found.reason : found.reason.substr(colon + 2));
    }
    if (found.verdict.starts_with("unstable:")) cell.kind = "unstable";
    else if (found.verdict != "ok") cell.kind = "failed";
    else if (!(found.error <= bound)) cell.kind = "inaccurate";
    return cell;
}

/// Without the time step that the scene's line gives.
Words without_step(const Words& command) {
    Words words;
    for (std::size_t i = 0; i < command.size(); ++i)
        if (command[i] == "--cfl") ++i;
        else words.push_back(command[i]);
    return words;
}

/// The error of that name, with what else the rows tell.
Found wanted(const Outcome& ended, const std::string& error, double& seconds) {
    const auto row = std::find_if(ended.rows.begin(), ended.rows.end(), [&](const SummaryRow& r) { return r.error_name == error; });
    const SummaryRow& first = ended.rows.front();
    seconds = std::isfinite(first.cpu_s) ? first.cpu_s : 0;
    return {error, first.verdict, first.reason, row == ended.rows.end() ? nan : row->error, first.dt, first.cfl, first.t_fail};
}

std::string folder_name(const ExtremeCase& row, const CaseColumn& column) {
    return file_safe(row.group + "_" + row.value, 80) + "/" + file_safe(column.name);
}

}  // namespace

std::string Cell::shown() const {
    if (kind == "none") return "-";
    if (kind == "unstable" || kind == "failed") {
        static const std::map<std::string, std::string> words{{"energy-growth", "energy"},        {"numerical-fracture", "fracture"},
                                                              {"inverted-particle", "inverted"},  {"domain-trouble", "domain"},
                                                              {"temperature-growth", "too hot"},  {"left-grid", "left grid"},
                                                              {"not-finite", "not finite"},       {"time-step-floor", "step floor"},
                                                              {"bodies-passed-through", "passed"}, {"massless-node", "massless"}};
        const std::string cause = verdict.substr(verdict.find(':') + 1);
        const auto short_word = words.find(cause);
        return short_word == words.end() ? cause : short_word->second;
    }
    char text[32];
    if (kind == "limit") {
        std::snprintf(text, sizeof text, verdict == "ok" ? "%.3g" : "> %.2g", error);
        return text;
    }
    if (verdict == "ok" && !std::isfinite(error)) return "no error";
    return Found{error_name, "ok", "", error, nan, nan, nan}.shown();
}

ExtremeRuns::ExtremeRuns(Programs& programs, const CaseTable& table, const std::string& folder, const RunRules& rules, bool quick)
    : programs_(programs), table_(table), folder_(folder), rules_(rules) {
    for (const ExtremeCase& row : table.cases)
        if (!quick || row.quick) cases_.push_back(row);
}

/// The run of a cell; without a program if it is not offered.
Run ExtremeRuns::run_of(const Words& command, const std::string& name, std::string& why_not) const {
    Run run;
    try {
        const Variant variant = programs_.variant(command, {"out", "label", "plot", "quiet", "dry-run", "help", "version", "describe"});
        run.program = variant.program;
        run.options = variant.options();
        run.cells = std::atoi(variant.value("cells").c_str());
        run.folder = "runs/" + table_.name + "/" + name;
        run.command = {programs_.path(variant.program), variant.words};
    } catch (const BadInput& refused) {
        why_not = refused.what();
        return {};
    }
    const auto tell = [&](const std::string& option, const Words& words) {
        if (programs_.accepts(run.program, option)) run.command.words.insert(run.command.words.end(), words.begin(), words.end());
    };
    tell("plot", {"--plot", "none"});
    tell("quiet", {"--quiet"});
    run.text = shell_text({run.program, run.command.words});
    tell("out", {"--out", std::filesystem::absolute(folder_ + "/" + run.folder).lexically_normal().string()});
    return run;
}

std::optional<Found> ExtremeRuns::found(const Run& run, const std::string& error, double& seconds) const {
    const bool known = !rules_.fresh && is_complete(folder_, run);
    const auto ended = known ? std::optional<Outcome>(outcome(folder_, run)) : run_one(folder_, run, rules_.timeout);
    if (!ended) return {};
    return wanted(*ended, error, seconds);
}

std::optional<Cell> ExtremeRuns::limit(const ExtremeCase& row, const CaseColumn& column, double& step) const {
    std::string why_not;
    const Words command = without_step(table_.command(row, column, why_not));
    const Run first = why_not.empty() ? run_of(command, folder_name(row, column) + "/own", why_not) : Run{};
    if (!why_not.empty()) return not_offered(why_not);
    double sum = 0, seconds = 0;
    std::string refused;
    int number = 0;
    const auto limit = largest_step(0.02, step, [&](const Words& more) -> std::optional<Found> {
        Words words = command;
        words.insert(words.end(), more.begin(), more.end());
        const Run run = run_of(words, folder_name(row, column) + "/" + std::to_string(number++), why_not);
        auto result = found(run, row.error, seconds);
        if (result && result->verdict == "failed:exit 2" && more.empty()) refused = judged(*result, 0, 0).reason;
        sum += seconds;
        return result;
    });
    if (!limit) return {};
    if (!refused.empty()) return not_offered(refused);
    if (!limit->stable) {
        const std::string verdict = limit->unstable ? limit->unstable->verdict : "failed:no step";
        return Cell{verdict.starts_with("unstable:") ? "unstable" : "failed", "fraction", verdict,
                    limit->unstable ? limit->unstable->reason : "", nan, nan, sum};
    }
    const std::string verdict = limit->unstable ? "ok" : "no limit found";
    return Cell{"limit", "fraction", verdict, limit->unstable ? "then " + limit->unstable->verdict : "", limit->stable->fraction, nan, sum};
}

std::optional<Cell> ExtremeRuns::at_step(const ExtremeCase& row, const CaseColumn& column) const {
    double critical = 0, seconds = 0;
    const auto found_limit = limit(row, column, critical);
    if (!found_limit) return {};
    if (found_limit->kind != "limit") return found_limit;
    if (found_limit->verdict != "ok") return not_offered("no largest step was found");
    std::string why_not;
    Words words = without_step(table_.command(row, column, why_not));
    // The search ended with a stable step and one 2 % larger that was not.
    words.insert(words.end(), {"--dt", number_text(row.part * 1.01 * found_limit->error * critical)});
    const Run run = run_of(words, folder_name(row, column) + "/part", why_not);
    const auto result = found(run, row.error, seconds);
    if (!result) return {};
    Cell cell = judged(*result, row.bound, seconds);
    if (row.part > 1 && cell.kind == "error") cell.kind = "inaccurate", cell.reason = "nothing was noticed beyond the largest stable step";
    return cell;
}

std::optional<std::vector<std::vector<Cell>>> ExtremeRuns::all() {
    std::vector<std::vector<Cell>> cells(cases_.size(), std::vector<Cell>(table_.columns.size()));
    struct Place {
        std::size_t row, column;
    };
    std::vector<Run> runs;
    std::vector<Place> places;
    for (std::size_t r = 0; r < cases_.size(); ++r)
        for (std::size_t c = 0; c < table_.columns.size() && cases_[r].kind == ExtremeCase::Kind::run; ++c) {
            std::string why_not;
            const Words command = table_.command(cases_[r], table_.columns[c], why_not);
            const Run run = why_not.empty() ? run_of(command, folder_name(cases_[r], table_.columns[c]), why_not) : Run{};
            if (why_not.empty()) runs.push_back(run), places.push_back({r, c});
            else cells[r][c] = not_offered(why_not);
        }
    if (!run_sweep(folder_, runs, rules_, [](const Run&) {})) return {};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto [r, c] = places[i];
        double seconds = 0;
        const Found result = wanted(outcome(folder_, runs[i]), cases_[r].error, seconds);
        cells[r][c] = judged(result, cases_[r].bound, seconds);
        if (cells[r][c].kind == "inaccurate") cells[r][c].known = table_.known(cases_[r], table_.columns[c]);
    }
    for (std::size_t r = 0; r < cases_.size(); ++r)
        for (std::size_t c = 0; c < table_.columns.size() && cases_[r].kind != ExtremeCase::Kind::run; ++c) {
            double critical = 0;
            const bool search = cases_[r].kind == ExtremeCase::Kind::limit;
            const auto cell = search ? limit(cases_[r], table_.columns[c], critical) : at_step(cases_[r], table_.columns[c]);
            if (!cell) return {};
            cells[r][c] = *cell;
        }
    return cells;
}

}  // namespace mpm
