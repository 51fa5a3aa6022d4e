#include "plots/stack.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "lab/record.hpp"
#include "plots/pareto.hpp"

namespace mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class... Values> std::string text(const char* format, Values... values) {
    char line[400];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

/// Fills `order` within rows first ... last, which are of one variant.
void fill_orders(std::vector<StackedRow>& rows, std::size_t first, std::size_t last) {
    std::vector<SummaryRow> own;
    for (std::size_t i = first; i < last; ++i) own.push_back(rows[i].row);
    mpm::fill_orders(own);
    for (std::size_t i = first; i < last; ++i) rows[i].row = own[i - first];
}

/// 1 %, 0.1 %, 1e-4 ...
std::string level_text(int decade) { return decade >= -3 ? text("%g %%", 100 * std::pow(10, decade)) : text("1e%d", decade); }

}  // namespace

std::vector<StackedRow> stack(const std::string& folder, const std::vector<Run>& runs, bool all) {
    std::vector<StackedRow> rows;
    std::size_t first = 0;
    for (const Run& run : runs) {
        if (!rows.empty() && rows.back().variant != run.variant) {
            fill_orders(rows, first, rows.size());
            first = rows.size();
        }
        Outcome found = outcome(folder, run);
        if (!found.ended && !all) continue;
        for (SummaryRow& row : found.rows) rows.push_back({run.variant, std::move(row)});
    }
    fill_orders(rows, first, rows.size());
    return rows;
}

void write_stack(const std::string& path, const std::vector<StackedRow>& rows) {
    const auto line = [](std::vector<std::string> fields) {
        for (std::string& field : fields) field = csv_field(field);
        return joined(fields, ",") + "\n";
    };
    std::string lines = line(summary_columns());
    for (const StackedRow& r : rows) lines += line(summary_fields(r.row));
    write_file(path, lines);
}

bool all_well(const std::vector<StackedRow>& rows) {
    return std::all_of(rows.begin(), rows.end(), [](const StackedRow& r) { return r.row.verdict == "ok"; });
}

std::vector<std::string> error_names(const std::vector<StackedRow>& rows) {
    std::vector<std::string> names;
    for (const StackedRow& r : rows)
        if (r.row.error_name != "none" && std::find(names.begin(), names.end(), r.row.error_name) == names.end())
            names.push_back(r.row.error_name);
    return names;
}

bool Result::fits() const { return ok() && std::isfinite(error) && error > 0 && h > 0; }

double Series::order() const {
    std::vector<std::pair<double, double>> points;
    for (const Result& r : results)
        if (r.fits()) points.emplace_back(r.h, r.error);
    return fitted_order(points);
}

const Result* Series::reached(double error) const {
    const Result* best = nullptr;
    for (const Result& r : results)
        if (r.ok() && r.error <= error && (best == nullptr || r.seconds < best->seconds)) best = &r;
    return best;
}

std::vector<Series> series(const std::vector<Run>& runs, const std::vector<StackedRow>& rows, const std::string& error, bool cpu) {
    std::vector<Series> all;
    for (const Run& run : runs) {
        const auto variant = static_cast<std::size_t>(run.variant);
        if (all.size() <= variant) all.resize(variant + 1);
        all[variant].name = run.name;
        const SummaryRow* found = nullptr;  // of this run the row with that error or, if it has none, its first
        for (const StackedRow& r : rows)
            if (r.variant == run.variant && r.row.cells == run.cells && (found == nullptr || r.row.error_name == error)) found = &r.row;
        if (found == nullptr) continue;
        const bool has = found->error_name == error;
        all[variant].results.push_back({run.cells, found->h, has ? found->error : nan, has ? found->order : nan,
                                        cpu ? found->cpu_s : found->wall_s, found->peak_rss_kb, found->verdict, found->reason, run.program,
                                        run.folder});
    }
    return all;
}

bool unbeaten(const Result& one, const std::vector<Series>& all) {
    const auto better = [&](const Result& other) { return other.fits() && beats({other.error, other.seconds}, {one.error, one.seconds}); };
    return one.fits() &&
           std::none_of(all.begin(), all.end(), [&](const Series& s) { return std::any_of(s.results.begin(), s.results.end(), better); });
}

double fitted_order(const std::vector<std::pair<double, double>>& h_and_error) {
    const auto n = static_cast<double>(h_and_error.size());
    double x = 0, y = 0;
    for (const auto& [h, e] : h_and_error) x += std::log(h) / n, y += std::log(e) / n;
    double xx = 0, xy = 0;
    for (const auto& [h, e] : h_and_error) {
        xx += (std::log(h) - x) * (std::log(h) - x);
        xy += (std::log(h) - x) * (std::log(e) - y);
    }
    return xx > 0 ? xy / xx : nan;
}

std::string comparison_table(const std::vector<Series>& all, const std::string& error) {
    std::size_t width = 7;
    for (const Series& s : all) width = std::max(width, s.name.size());
    const int w = static_cast<int>(width);
    std::string lines = text("%-*s %7s %15s %6s %10s %9s  %s\n", w, "variant", "cells", error.c_str(), "order", "seconds", "MB", "verdict");
    for (const Series& s : all) {
        for (const Result& r : s.results)
            lines += text("%-*s %7d %15.3e %6.2f %10.3g %9.1f  %s\n", w, s.name.c_str(), r.cells, r.error, r.order, r.seconds,
                          static_cast<double>(r.memory_kb) / 1024, r.verdict.c_str());
        if (std::isfinite(s.order())) lines += text("%-*s %7s %15s %6.2f  fitted\n", w, s.name.c_str(), "", "", s.order());
    }
    for (const Series& s : all)
        for (const Result& r : s.results)
            if (!r.ok() && !r.reason.empty()) lines += s.name + ", " + std::to_string(r.cells) + " cells: " + r.reason + "\n";
    return lines;
}

std::string reached_lines(const std::vector<Series>& all) {
    std::string lines;
    for (const Series& s : all) {
        std::string line;
        for (int decade = -2, last = -2; decade >= -12; decade = last - 1) {
            const Result* r = s.reached(std::pow(10, decade));
            if (r == nullptr) break;
            for (last = decade; last > -12 && s.reached(std::pow(10, last - 1)) == r;) --last;  // one run may be good for several
            line += (line.empty() ? " reached " : ", ") + level_text(decade);
            if (last < decade) line += (last == decade - 1 ? " and " : " ... ") + level_text(last);
            line += text(" in %.3g s (%d cells)", r->seconds, r->cells);
        }
        if (line.empty())
            line = s.reached(std::numeric_limits<double>::infinity()) == nullptr ? ": no error to speak of" : " did not reach 1 %";
        lines += s.name + line + "\n";
    }
    return lines;
}

}  // namespace mpm
