#include "plots/findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

#include "plots/pareto.hpp"

namespace mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Outcome {
    std::size_t variant;
    Cost cost;
};

bool beaten(const Outcome& one, const std::vector<Outcome>& all) {
    return std::any_of(all.begin(), all.end(), [&](const Outcome& other) { return beats(other.cost, one.cost); });
}

/// "2 of 4 runs unstable:energy-growth", the verdicts that differ by commas.
std::string trouble_of(const CsvTable& errors, const std::string& name) {
    int runs = 0, lost = 0;
    std::string verdicts;
    for (std::size_t row = 0; row < errors.rows.size(); ++row) {
        if (errors.text(row, "name") != name) continue;
        ++runs;
        const std::string& verdict = errors.text(row, "verdict");
        if (verdict == "ok") continue;
        ++lost;
        if (verdicts.find(verdict) != std::string::npos) continue;
        if (!verdicts.empty()) verdicts += ", ";
        verdicts += verdict;
    }
    return lost == 0 ? "" : std::to_string(lost) + " of " + std::to_string(runs) + " runs " + verdicts;
}

}  // namespace

std::string command_of(const CsvTable& rows, std::size_t row) {
    std::string command = rows.text(row, "program");
    std::istringstream items(rows.text(row, "options"));
    for (std::string item; std::getline(items, item, ';');) {
        if (item.empty() || item.starts_with("cells=")) continue;
        const std::size_t is = item.find('=');
        command += " --" + item.substr(0, is);
        if (is != std::string::npos && item.substr(is) != "=true") command.append(" ").append(item, is + 1);
    }
    return command;
}

std::vector<Finding> findings(const CsvTable& errors) {
    std::vector<Finding> found;
    std::vector<Outcome> all;
    const Reached none{nan, nan, 0};
    for (std::size_t row = 0; row < errors.rows.size(); ++row) {
        const std::string name = errors.text(row, "name");
        auto same = std::find_if(found.begin(), found.end(), [&](const Finding& f) { return f.name == name; });
        if (same == found.end()) same = found.insert(found.end(), {name, none, {none, none, none}, false, trouble_of(errors, name)});
        const Reached run{errors.number(row, "error"), errors.number(row, "seconds"), static_cast<int>(errors.number(row, "cells"))};
        if (errors.text(row, "verdict") != "ok" || std::isnan(run.error) || std::isnan(run.seconds)) continue;
        all.push_back({static_cast<std::size_t>(same - found.begin()), {run.error, run.seconds}});
        if (!(same->finest.error <= run.error)) same->finest = run;
        for (std::size_t i = 0; i < error_levels.size(); ++i)
            if (run.error <= error_levels[i] && !(same->levels[i].seconds <= run.seconds)) same->levels[i] = run;
    }
    for (const Outcome& one : all)
        if (!beaten(one, all)) found[one.variant].best = true;
    std::stable_sort(found.begin(), found.end(), [](const Finding& a, const Finding& b) {
        if (a.best != b.best) return a.best;
        return a.finest.error < b.finest.error || (std::isnan(b.finest.error) && !std::isnan(a.finest.error));
    });
    return found;
}

}  // namespace mpm
