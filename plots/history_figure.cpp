#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "lab/csv_read.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "plots/compare_figures.hpp"
#include "plots/script.hpp"

namespace mpm {
namespace {

/// One run's history file.
struct History {
    std::size_t variant;
    const Result* result;
    std::string path;  // below the folder of the sweep
    CsvTable table;
};

/// The history of each variant at `cells` (0: the finest that ended well, or else the finest), where it has the column.
std::vector<History> histories(const Subject& s, const std::string& column, int cells, std::vector<std::string>& known) {
    std::vector<History> found;
    for (std::size_t v = 0; v < s.series.size(); ++v) {
        const Result* best = nullptr;
        for (const Result& r : s.series[v].results) {
            if (cells > 0 ? r.cells != cells : best != nullptr && std::pair(best->ok(), best->cells) > std::pair(r.ok(), r.cells)) continue;
            best = &r;
        }
        if (best == nullptr || !std::filesystem::exists(s.folder + "/" + best->folder + "/history.csv")) continue;
        const std::string path = best->folder + "/history.csv";
        CsvTable table = read_csv(s.folder + "/" + path);
        for (const std::string& name : table.columns)
            if (name != "t" && !name.ends_with("_exact") && std::find(known.begin(), known.end(), name) == known.end())
                known.push_back(name);
        if (table.has("t") && table.has(column)) found.push_back({v, best, path, std::move(table)});
    }
    return found;
}

struct Span {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double x) {
        if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    }
};

/// Where a signal passes its mean.
std::vector<double> crossings(const CsvTable& table, const std::string& column) {
    double mean = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) mean += table.number(i, column) / static_cast<double>(table.rows.size());
    std::vector<double> times;
    for (std::size_t i = 1; i < table.rows.size(); ++i)
        if ((table.number(i - 1, column) - mean) * (table.number(i, column) - mean) < 0) times.push_back(table.number(i, "t"));
    return times;
}

/// v_cm as a symbol with its index.
std::string symbol(const std::string& column) {
    const std::size_t mark = column.find('_');
    if (mark == std::string::npos || mark == 0) return plain(column);
    const std::string text = column.substr(0, mark) + "_{" + column.substr(mark + 1) + "}";
    return text.find('_', mark + 1) == std::string::npos ? formula(text, "$" + text + "$") : plain(column);
}

/// What the program's own figure calls the column, with its unit, or else the column's name.
std::string label(const std::string& run_folder, const std::string& program, const std::string& column) {
    const std::string path = run_folder + "/" + program + ".gp", head = "set ylabel ";
    if (!std::filesystem::exists(path)) return plain(column);
    const std::string script = read_file(path);
    const std::size_t curve = script.find("(column(" + gnuplot_text(column) + "))");
    const std::size_t start = curve == std::string::npos ? curve : script.rfind(head, curve);
    if (start == std::string::npos) return plain(column);
    return script.substr(start + head.size(), script.find('\n', start) - start - head.size());
}

}  // namespace

std::string write_history_figure(const Subject& s, const std::string& column, int cells, std::vector<std::string>& files) {
    constexpr std::size_t shown =
        12;  // half swings; a longer signal is shown in its first and its last ones, where phases have had time to part
    std::vector<std::string> known;
    const std::vector<History> all = histories(s, column, cells, known);
    if (all.empty()) {
        throw BadInput("--history " + one_line(column) + ": no run has this column" +
                       (known.empty() ? "" : "; known are " + joined(known, ", ")));
    }
    const std::string exact = column + "_exact";
    const auto with_exact = std::find_if(all.begin(), all.end(), [&](const History& h) { return h.result->ok() && h.table.has(exact); });
    const bool some_ok = std::any_of(all.begin(), all.end(), [](const History& h) { return h.result->ok(); });

    Span t, y;  // unstable runs do not stretch the axes, unless there is nothing else
    for (const History& h : all)
        for (std::size_t i = 0; i < h.table.rows.size() && (h.result->ok() || !some_ok); ++i)
            t.add(h.table.number(i, "t")), y.add(h.table.number(i, column));
    if (!(t.low < t.high)) throw BadInput("--history " + one_line(column) + ": there is no time to draw");
    const double room = y.high > y.low ? 0.06 * (y.high - y.low) : std::max(1e-300, std::abs(y.high));

    const bool has_exact = with_exact != all.end();
    const History& leader = has_exact ? *with_exact : all.front();
    const std::vector<double> times = crossings(leader.table, has_exact ? exact : column);
    std::vector<std::pair<double, double>> spans{{t.low, t.high}};
    if (times.size() > 2 * shown) spans = {{t.low, times[shown]}, {times[times.size() - shown], t.high}};

    // Panels of one size, in pixels; the legend hangs below the last one.
    const int top = 70, panel = 400, gap = 90, panels = static_cast<int>(spans.size());
    const int height = top + panels * (panel + gap) + legend_height(all.size() + 1);
    const std::string name = "history_" + file_safe(column);
    std::string text = script_head(name, 1200, height, "") + "unset title\nset multiplot title " +
                       plain(s.scene + (s.shared.empty() ? "" : ", " + one_line(s.shared, 50)) + ": ") + " . " +
                       label(s.folder + "/" + leader.result->folder, leader.result->program, column) + "\nset ylabel " + symbol(column) +
                       "\nset xlabel " + formula("time t [time]", "time $t$ [time]") + "\nset yrange [" + number_text(y.low - room) + ":" +
                       number_text(y.high + room) + "]\nset lmargin 10\nset rmargin 3\n";
    for (int p = 0; p < panels; ++p) {
        const auto [from, to] = spans[static_cast<std::size_t>(p)];
        const double ceiling = top + p * (panel + gap);
        const double part = (to - from) / (t.high - t.low);  // of the rows, in this panel
        text += "set tmargin at screen " + number_text(1 - ceiling / height) + "\nset bmargin at screen " +
                number_text(1 - (ceiling + panel) / height) + "\nset xrange [" + number_text(from) + ":" + number_text(to) + "]\n" +
                (p + 1 == panels ? legend : "unset key\n") + "plot ";
        for (std::size_t i = 0; i < all.size(); ++i) {
            const History& h = all[i];
            const std::string title = s.series[h.variant].name + ", " + std::to_string(h.result->cells) + " cells" +
                                      (h.result->ok() ? "" : ", " + h.result->verdict);
            const double markers = 11 + 2 * static_cast<double>(h.variant);  // not at the same places for each
            const int every = std::max(1, static_cast<int>(static_cast<double>(h.table.rows.size()) * part / markers));
            text += std::string(i > 0 ? ", \\\n     " : "") + gnuplot_text(h.path) + " using (column('t')):(column(" +
                    gnuplot_text(column) + ")) with linespoints " + curve_style(h.variant) + " pi " + std::to_string(every) + " title " +
                    plain(title);
        }
        if (has_exact)
            text += ", \\\n     " + gnuplot_text(leader.path) + " using (column('t')):(column(" + gnuplot_text(exact) +
                    ")) with lines lw 1.5 lc rgb '#808080' title 'exact'";
        text += "\n";
    }
    text += "unset multiplot\n";
    write_file(s.folder + "/" + name + ".gp", text);
    files.push_back(s.folder + "/" + name + ".gp");
    return name;
}

}  // namespace mpm
