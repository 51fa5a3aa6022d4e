#include "plots/stability_cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/run.hpp"

namespace mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// 1e6 as 10^{6}, other numbers as they are.
std::string power_text(const std::string& number) { return number.starts_with("1e") ? "10^{" + number.substr(2) + "}" : number; }

}  // namespace

std::vector<Case> stiff_cases(const Words& contrasts, const Limits& limits, int ppc) {
    std::vector<Case> cases;
    const auto add = [&](const std::string& name, const std::string& value, int cells, double periods, const std::string& option) {
        Case stiff{name, value, "", "", "", cells, periods, {}, {}};
        if (!option.empty()) stiff.needs = {option}, stiff.words = {"--" + option, value};
        cases.push_back(stiff);
        return &cases.back();
    };
    for (const std::string& contrast : contrasts) {
        const bool plain = std::strtod(contrast.c_str(), nullptr) == 1;  // the bar as it is needs no option
        Case* stiff = add("contrast", contrast, limits.cells, limits.case_periods, plain ? "" : "contrast");
        stiff->title = plain ? "both halves of the bar alike" : "second half " + contrast + " times as stiff";
        stiff->above = "E_2/E_1";
        stiff->below = power_text(contrast);
    }
    // The first particle of each cell just inside it, the node behind the last one left with next to no mass.
    Case* tiny = add("tiny-mass", number_text(1e-12 - 0.5 / ppc), limits.cells, limits.case_periods, "offset");
    tiny->title = "particles 1e-12 h from a node";
    tiny->above = "10^{-12} h";
    tiny->below = "from node";
    for (int power = 8; power <= 12; power += 2) {
        if (1 << power > limits.finest) continue;
        Case* fine = add("fine", std::to_string(1 << power), 1 << power, 1, "");
        fine->title = "fine grid";
        fine->above = "h =";
        fine->below = "L/" + fine->value;
    }
    return cases;
}

std::string Found::shown() const {
    if (verdict == "ok") {
        if (!std::isfinite(error)) return "no error";
        char text[32];
        std::snprintf(text, sizeof text, "%.1e", error);
        std::string short_text = text;  // 1.9e-4
        const std::size_t zero = short_text.find("e-0");
        if (zero != std::string::npos) short_text.erase(zero + 2, 1);
        if (short_text.ends_with("e+00")) short_text.erase(short_text.size() - 4);
        return short_text;
    }
    return verdict.substr(verdict.find(':') == std::string::npos ? 0 : verdict.find(':') + 1);
}

Prober::Prober(Programs& programs, const Variant& variant, const Limits& limits, const std::string& folder)
    : programs_(programs), variant_(variant), limits_(limits), folder_(folder) {}

std::optional<Found> Prober::run(const std::string& name, int cells, double periods, const Words& more) {
    Run run;
    run.program = variant_.program;
    run.options = variant_.options();
    run.cells = cells;
    run.folder = "runs/" + variant_.file_name() + "/" + file_safe(name);
    run.command = {programs_.path(variant_.program), variant_.words};
    const auto tell = [&](const std::string& option, const Words& words) {
        if (programs_.accepts(variant_.program, option)) run.command.words.insert(run.command.words.end(), words.begin(), words.end());
    };
    tell("cells", {"--cells", std::to_string(cells)});
    tell("periods", {"--periods", number_text(periods)});
    tell("watch", {"--watch", "stop"});
    tell("plot", {"--plot", "none"});
    tell("quiet", {"--quiet"});
    run.command.words.insert(run.command.words.end(), more.begin(), more.end());
    run.text = shell_text({variant_.program, run.command.words});
    tell("out", {"--out", std::filesystem::absolute(folder_ + "/" + run.folder).lexically_normal().string()});

    const auto outcome = run_one(folder_, run, limits_.timeout);
    if (!outcome) return {};
    const SummaryRow* row = &outcome->rows.front();
    for (const SummaryRow& other : outcome->rows)
        if (other.error_name == limits_.error) row = &other;
    const bool wanted = limits_.error.empty() || row->error_name == limits_.error;
    return Found{row->error_name, row->verdict, row->reason, wanted ? row->error : nan, row->dt, row->cfl, row->t_fail};
}

std::string critical_name(Programs& programs, const std::string& program) {
    const CsvTable& options = programs.describe(program);
    for (std::size_t i = 0; i < options.rows.size() && options.has("unit"); ++i)
        if (options.text(i, "name") == "cfl" && options.text(i, "unit") != "-") return options.text(i, "unit");
    return wave_limit;
}

std::optional<Limit> largest_step(double tolerance, double& critical_dt,
                                  const std::function<std::optional<Found>(const Words& more)>& run) {
    constexpr double lowest = 1e-4, highest = 64;  // fractions of the critical step between which it looks
    // With its own step first: the row says what the step is in units of the critical one.
    const auto own = run({});
    if (!own) return {};
    critical_dt = own->dt / own->fraction;
    if (!(critical_dt > 0) || !std::isfinite(critical_dt)) {
        Limit none;
        none.unstable = Trial{nan, nan, own->verdict, own->reason};
        return none;
    }
    return largest_stable(1, lowest, highest, tolerance, [&](double fraction) -> std::optional<Trial> {
        const auto found = run({"--dt", number_text(fraction * critical_dt)});
        if (!found) return {};
        return Trial{std::isfinite(found->fraction) ? found->fraction : fraction, found->error, found->verdict, found->reason};
    });
}

std::optional<Limit> Prober::largest_step() {
    return mpm::largest_step(limits_.tolerance, critical_dt_, [&](const Words& more) {
        return run(more.empty() ? "own-step" : "step", limits_.cells, limits_.periods, more);
    });
}

std::optional<Found> Prober::run(const Case& stiff) {
    for (const std::string& option : stiff.needs)
        if (!programs_.accepts(variant_.program, option))
            return Found{"none", "left out", variant_.program + " has no option --" + option, nan, nan, nan, nan};
    return run(stiff.name + "-" + stiff.value, stiff.cells, stiff.periods, stiff.words);
}

int Prober::particles_per_cell() const { return std::max(1, std::atoi(variant_.value("ppc").c_str())); }

}  // namespace mpm
