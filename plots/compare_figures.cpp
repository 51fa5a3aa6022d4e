#include "plots/compare_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lab/options.hpp"
#include "lab/record.hpp"
#include "plots/script.hpp"

namespace mpm {
namespace {

std::string title(const Subject& s, const std::string& what) {
    return what + ": " + s.scene + (s.shared.empty() ? "" : ", " + one_line(s.shared, 50));
}

std::string number(double x, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// How many runs of a variant did not end well, for its legend.
std::string losses(const Series& series) {
    const auto lost = std::count_if(series.results.begin(), series.results.end(), [](const Result& r) { return !r.ok(); });
    return lost == 0 ? "" : " (" + std::to_string(lost) + " of " + std::to_string(series.results.size()) + " runs unstable or failed)";
}

/// The curves of all variants over one column of errors.csv; a variant without a point keeps its line in the legend.
std::string curves(const Subject& s, const std::string& x, bool with_order) {
    std::string lines = legend + std::string("plot ");
    for (std::size_t v = 0; v < s.series.size(); ++v) {
        const Series& series = s.series[v];
        const double order = series.order();
        const std::string name =
            series.name + (with_order && std::isfinite(order) ? ": order " + number(order, "%.2f") : "") + losses(series);
        if (v > 0) lines += ", \\\n     ";
        const bool any = std::any_of(series.results.begin(), series.results.end(), [](const Result& r) { return r.fits(); });
        if (any)
            lines +=
                "'errors.csv' using (column('variant') == " + std::to_string(v + 1) + " ? column('" + x + "') : NaN):(column('error'))";
        else
            lines += "NaN";
        lines += " with linespoints " + curve_style(v) + " title " + plain(name);
    }
    return lines + "\n";
}

}  // namespace

std::vector<std::string> write_error_figures(const Subject& s, std::vector<std::string>& files) {
    const std::string csv = s.folder + "/errors.csv";
    files.push_back(csv);
    CsvFile file(csv, {"variant", "name", "cells", "h", "error_name", "error", "order", "seconds", "memory_kb", "verdict", "reason"});
    std::vector<double> h, error, seconds;
    for (std::size_t v = 0; v < s.series.size(); ++v) {
        for (const Result& r : s.series[v].results) {
            file.row({std::to_string(v + 1), s.series[v].name, std::to_string(r.cells), number_text(r.h), s.error, number_text(r.error),
                      number_text(r.order), number_text(r.seconds), std::to_string(r.memory_kb), r.verdict, r.reason});
            if (!r.fits()) continue;
            error.push_back(r.error);
            if (r.seconds > 0) seconds.push_back(r.seconds);
            if (std::none_of(h.begin(), h.end(), [&](double known) { return std::abs(known / r.h - 1) < 1e-9; })) h.push_back(r.h);
        }
    }
    if (h.empty()) return {};
    const auto span = [](char axis, const std::vector<double>& values) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return log_axis(axis, *low, *high);
    };
    std::vector<std::string> names;
    const auto write = [&](const std::string& name, const std::string& text) {
        write_file(s.folder + "/" + name + ".gp", text);
        files.push_back(s.folder + "/" + name + ".gp");
        names.push_back(name);
    };
    const std::string y = "set ylabel " + plain("error: " + s.error) + "\n" + span('y', error);
    if (!seconds.empty())
        write("work_precision",
              script_head("work_precision", 1100, 740 + legend_height(s.series.size()), title(s, "Error against run time")) +
                  "set xlabel 'run time of the method [s]'\n" + span('x', seconds) + y + curves(s, "seconds", false));
    write("convergence", script_head("convergence", 1100, 740 + legend_height(s.series.size()), title(s, "Error against cell size")) +
                             "set xlabel " + formula("cell size h [length]", "cell size $h$ [length]") + "\n" +
                             (h.size() <= 8 ? log_axis('x', h) : span('x', h)) + y + curves(s, "h", true));
    return names;
}

}  // namespace mpm
