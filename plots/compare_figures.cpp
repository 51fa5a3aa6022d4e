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
    if (!s.title.empty()) return s.title;
    return what + ": " + s.scene + (s.shared.empty() ? "" : ", " + one_line(s.shared, 50));
}

std::string number(double x, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// How many runs of a variant did not end well and, if it is one cause and the line has room for it, why, for its legend.
std::string losses(const Series& series) {
    constexpr std::size_t room = 72;  // letters of a legend's line
    std::size_t lost = 0;
    std::string verdict;
    for (const Result& r : series.results) {
        if (r.ok()) continue;
        const std::size_t colon = std::min(r.verdict.find(':'), r.verdict.size() - 1);
        const std::string own = r.verdict.substr(0, colon) + ": " + r.verdict.substr(colon + 1);
        verdict = lost++ == 0 || verdict == own ? own : "unstable or failed";
    }
    if (lost == 0) return "";
    const std::string count = std::to_string(lost) + " of " + std::to_string(series.results.size()) + " ",
                      why = " (" + count + verdict + ")";
    return series.name.size() + why.size() <= room ? why : " (" + count + "lost)";
}

/// One figure's curves: what they show, and of which variants.
struct Curves {
    const Subject& s;
    std::vector<std::size_t> order;  // of the legend: those first that are beaten by no other, who are drawn bold
    std::vector<bool> best;

    explicit Curves(const Subject& subject) : s(subject), best(subject.series.size()) {
        for (std::size_t v = 0; v < best.size(); ++v) {
            order.push_back(v);
            for (const Result& r : s.series[v].results) best[v] = best[v] || unbeaten(r, s.series);
        }
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return best[a] && !best[b]; });
    }

    /// Legend and curves over one column of errors.csv; a variant without a point keeps its line in the legend.
    std::string over(const std::string& x, std::size_t& lines) const {
        std::vector<std::string> names;
        std::string text;
        const bool front = x == "seconds";
        if (front) {
            names.emplace_back("bold: no run is as good and as fast");
            text += "'front.csv' using (column('seconds')):(column('error')) with linespoints lw 11 pt 7 ps 3.4 lc rgb '#dcdcdc' title " +
                    plain(names.back());
        }
        for (const std::size_t v : order) {
            const Series& series = s.series[v];
            const double slope = series.order();
            const std::string more = (!front && std::isfinite(slope) ? ": order " + number(slope, "%.2f") : "") + losses(series);
            names.push_back(series.name + more);
            const bool any = std::any_of(series.results.begin(), series.results.end(), [](const Result& r) { return r.fits(); });
            text += text.empty() ? "" : ", \\\n     ";
            text += any ? "'errors.csv' using (column('variant') == " + std::to_string(v + 1) + " ? column('" + x +
                              "') : NaN):(column('error'))"
                        : "NaN";
            text += " with linespoints " + curve_style(v, !best[v]) + " title ";
            text += best[v] ? "(tex ? '\\textbf{' : '{/:Bold ') . " + plain(series.name) + " . '}' . " + plain(more) : plain(names.back());
        }
        return legend_of(names, lines) + "plot " + text + "\n";
    }
};

/// The numbers of cells that marks stand for.
std::string marks(const Subject& s) {
    std::vector<int> cells;
    for (const Series& series : s.series)
        for (const Result& r : series.results)
            if (std::find(cells.begin(), cells.end(), r.cells) == cells.end()) cells.push_back(r.cells);
    std::string text = "marks: ";
    for (const int n : cells) text += (n == cells.front() ? "" : ", ") + std::to_string(n);
    return text + " cells";
}

std::string span(char axis, const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return log_axis(axis, *low, *high);
}

/// front.csv: the runs that none beats, the fastest first.
void write_front(const Subject& s, std::vector<std::string>& files) {
    std::vector<std::pair<const Result*, std::string>> front;
    for (const Series& series : s.series)
        for (const Result& r : series.results)
            if (unbeaten(r, s.series)) front.emplace_back(&r, series.name);
    std::sort(front.begin(), front.end(), [](const auto& a, const auto& b) { return a.first->seconds < b.first->seconds; });
    files.push_back(s.folder + "/front.csv");
    CsvFile file(files.back(), {"seconds", "error", "name", "cells"});
    for (const auto& [r, name] : front) file.row({number_text(r->seconds), number_text(r->error), name, std::to_string(r->cells)});
}

}  // namespace

std::vector<std::string> write_error_figures(const Subject& s, std::vector<std::string>& files) {
    const std::string csv = s.folder + "/errors.csv";
    files.push_back(csv);
    CsvFile file(csv,
                 {"variant", "name", "cells", "h", "error_name", "error", "order", "seconds", "memory_kb", "best", "verdict", "reason"});
    std::vector<double> h, error, seconds;
    for (std::size_t v = 0; v < s.series.size(); ++v) {
        for (const Result& r : s.series[v].results) {
            file.row({std::to_string(v + 1), s.series[v].name, std::to_string(r.cells), number_text(r.h), s.error, number_text(r.error),
                      number_text(r.order), number_text(r.seconds), std::to_string(r.memory_kb), unbeaten(r, s.series) ? "1" : "0",
                      r.verdict, r.reason});
            if (!r.fits()) continue;
            error.push_back(r.error);
            if (r.seconds > 0) seconds.push_back(r.seconds);
            if (std::none_of(h.begin(), h.end(), [&](double known) { return std::abs(known / r.h - 1) < 1e-9; })) h.push_back(r.h);
        }
    }
    if (h.empty()) return {};
    write_front(s, files);
    std::vector<std::string> names;
    const Curves curves(s);
    const std::string y = "set ylabel " + plain(s.error_label.empty() ? "error: " + s.error : s.error_label) + "\n" + span('y', error);
    const auto write = [&](const std::string& name, const std::string& what, const std::string& x, const std::string& axis) {
        std::size_t lines = 0;
        const std::string drawn = curves.over(x, lines);
        write_file(s.folder + "/" + name + ".gp", script_head(name, 1100, 740 + legend_height(lines), title(s, what)) + axis + y + drawn);
        files.push_back(s.folder + "/" + name + ".gp");
        names.push_back(name);
    };
    if (!seconds.empty())
        write("work_precision", "error against run time", "seconds",
              "set xlabel " + plain((s.cpu ? "CPU time of the method [s]; " : "run time of the method [s]; ") + marks(s)) + "\n" +
                  span('x', seconds));
    write("convergence", "error against cell size", "h",
          "set xlabel " + formula("cell size h [length]", "cell size $h$ [length]") + "\n" +
              (h.size() <= 8 ? log_axis('x', h) : span('x', h)));
    return names;
}

}  // namespace mpm
