#include "plots/stability_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "lab/record.hpp"
#include "plots/script.hpp"

namespace mpm {
namespace {

std::string failure(const Trial& trial) { return trial.verdict.substr(trial.verdict.find(':') + 1); }

/// Names of the variants on the vertical axis, the first on top.
std::string variant_tics(const std::vector<Probed>& probed) {
    std::string tics;
    for (std::size_t v = 0; v < probed.size(); ++v) {
        if (v > 0) tics += ", ";
        tics += plain(probed[v].name) + " " + std::to_string(v + 1);
    }
    return "set ytics (" + tics + ")\nset yrange [" + std::to_string(probed.size()) + ".5:0.5]\nset grid noytics\n";
}

/// A long label in two lines: broken after its first hyphen or space.
std::pair<std::string, std::string> broken(const std::string& text) {
    const std::size_t end = text.find_first_of("- ");
    if (text.size() <= 9 || end == std::string::npos) return {text, ""};
    return {text.substr(0, text[end] == '-' ? end + 1 : end), text.substr(end + 1)};
}

/// Two lines over a column; only a string in double quotes breaks its line.
std::string two_lines(const std::string& above, const std::string& below) {
    const auto latex = [](const std::string& text) { return text.find_first_of("_^") == std::string::npos ? text : "$" + text + "$"; };
    return "(tex ? " + gnuplot_text("\\shortstack{" + latex(above) + "\\\\" + latex(below) + "}") + " : \"" + above + "\\n" + below + "\")";
}

/// Room for the longest name left of the axis, in characters.
int margin(const std::vector<Probed>& probed) {
    std::size_t longest = 8;
    for (const Probed& p : probed) longest = std::max(longest, p.name.size());
    return static_cast<int>(longest) + 2;
}

/// The axis of the largest steps, in units of the critical one, which it names if that is the same for all.
std::string step_label(const std::vector<Probed>& probed) {
    const bool one = std::all_of(probed.begin(), probed.end(), [&](const Probed& p) { return p.unit == probed.front().unit; });
    if (!one) return gnuplot_text("largest stable time step / critical step");
    const auto spelled = [&](const std::string& kappa) {
        std::string unit = probed.front().unit;
        if (const std::size_t at = unit.find("kappa"); at != std::string::npos) unit.replace(at, 5, kappa);
        return unit;
    };
    return formula("largest stable time step Δt / [" + spelled("κ") + "]",
                   "largest stable time step $\\Delta t / [" + spelled("\\kappa") + "]$");
}

}  // namespace

std::string limit_text(const Limit& limit) {
    char text[40] = "";
    if (limit.stable) std::snprintf(text, sizeof text, "%.3g", limit.stable->fraction);
    if (!limit.unstable) return std::string(text) + " (the largest tried)";
    if (!limit.stable) return "no stable step (" + failure(*limit.unstable) + ")";
    return std::string(text) + " (then " + failure(*limit.unstable) + ")";
}

std::string write_step_figure(const std::string& folder, const std::string& title, const std::vector<Probed>& probed,
                              std::vector<std::string>& files) {
    const std::string name = "stability_steps", csv = folder + "/" + name + ".csv";
    CsvFile file(csv, {"row", "name", "largest_stable", "beyond"});
    double widest = 1;
    for (std::size_t v = 0; v < probed.size(); ++v) {
        const Limit& limit = probed[v].limit;
        const double fraction = limit.stable ? limit.stable->fraction : 0;
        file.row({std::to_string(v + 1), probed[v].name, number_text(fraction), limit_text(limit)});
        widest = std::max(widest, fraction);
    }
    std::string text = script_head(name, 1200, 190 + 62 * static_cast<int>(probed.size()), title);
    text += "set lmargin " + std::to_string(margin(probed)) + "\n" + variant_tics(probed) + "set xrange [0:" + number_text(2.1 * widest) +
            "]\n";
    text += "set xlabel " + step_label(probed) +
            "\nset xtics nomirror\nset ytics nomirror scale 0\nunset key\nset style textbox opaque noborder margins 0.3,0.3\nset style "
            "fill solid 0.9 border lc rgb 'black'\nset arrow from 1, graph 0 to 1, graph 1 nohead back dt (10,6) lw 2 lc rgb '#303030'\n";
    text += "plot '" + name +
            ".csv' using (column('largest_stable')/2):(column('row')):(column('largest_stable')/2):(0.32) with boxxyerror lc rgb "
            "'#7fa8d1', \\\n"
            "     '" +
            name +
            ".csv' using (column('largest_stable')):(column('row')):(strcol('beyond')) with labels left offset 0.9,0 noenhanced boxed "
            "notitle\n";
    write_file(folder + "/" + name + ".gp", text);
    files.insert(files.end(), {csv, folder + "/" + name + ".gp"});
    return name;
}

std::string write_case_map(const std::string& folder, const std::string& title, const std::vector<Case>& cases,
                           const std::vector<Probed>& probed, std::vector<std::string>& files) {
    const std::string name = "stability_map", csv = folder + "/" + name + ".csv";
    constexpr double best = -6, worst = 0;  // decades of error between which the shade changes
    CsvFile file(csv, {"row", "column", "kind", "level", "ink", "shift", "shown"});
    std::string heads;
    int column = 0;
    for (std::size_t c = 0; c < cases.size(); ++c) {
        if (std::all_of(probed.begin(), probed.end(), [&](const Probed& p) { return p.found[c].verdict == "left out"; })) continue;
        ++column;
        if (column > 1) heads += ", ";
        heads += two_lines(cases[c].above, cases[c].below) + " " + std::to_string(column);
        for (std::size_t v = 0; v < probed.size(); ++v) {
            const Found& f = probed[v].found[c];
            const bool ok = f.verdict == "ok";
            const double level = ok && std::isfinite(f.error) ? std::clamp(std::log10(std::max(f.error, 1e-300)), best, worst) : worst;
            const std::string kind = ok                        ? "error"
                                     : f.verdict == "left out" ? "none"
                                                               : "unstable",
                              ink = kind == "unstable" ? "16777215" : "0";
            const auto [first, second] = broken(f.shown());
            const auto line = [&](const std::string& what, const std::string& shift, const std::string& text) {
                file.row({std::to_string(v + 1), std::to_string(column), what, number_text(level), ink, shift, text});
            };
            line(kind, second.empty() ? "0" : "-0.13", first);
            if (!second.empty()) line("text", "0.13", second);
        }
    }
    if (column == 0) return "";
    std::string text = script_head(name, 15 * (margin(probed) + 11) + 152 * column, 270 + 74 * static_cast<int>(probed.size()), title) +
                       "set title offset 0,2\nset tmargin 7\nset rmargin 11\n";
    text += "set lmargin " + std::to_string(margin(probed)) + "\n" + variant_tics(probed) + "set xrange [0.5:" + std::to_string(column) +
            ".5]\nset x2range [0.5:" + std::to_string(column) + ".5]\nunset xtics\nset x2tics (" + heads +
            ") scale 0\nset ytics scale 0\nunset grid\nunset key\n";
    text += "set palette defined (0 '#f7fbff', 0.5 '#a6cde5', 1 '#4a90c4')\nset cbrange [" + number_text(best) + ":" + number_text(worst) +
            "]\nset cbtics (";
    for (int decade = static_cast<int>(best); decade <= worst; ++decade) {
        if (decade > best) text += ", ";
        text += formula("10^{" + std::to_string(decade) + "}", "$10^{" + std::to_string(decade) + "}$") + " " + std::to_string(decade);
    }
    const auto only = [](const std::string& kind, const std::string& value) {
        return "(strcol('kind') eq '" + kind + "' ? " + value + " : NaN)";
    };
    const std::string box = ":(column('row')):(0.5):(0.5)", source = "'" + name + ".csv' using ";
    text += ")\nset cblabel 'relative error'\nset style fill solid 1 border lc rgb '#606060'\nplot " + source +
            only("error", "column('column')") + box + ":(column('level')) with boxxyerror fc palette, \\\n     " + source +
            only("unstable", "column('column')") + box + " with boxxyerror fc rgb '#202020', \\\n     " + source +
            only("none", "column('column')") + box + " with boxxyerror fc rgb 'white', \\\n     " + source +
            "(column('column')):(column('row') + column('shift')):(strcol('shown')):(column('ink')) with labels tc rgb variable font ',15' "
            "noenhanced\n";
    write_file(folder + "/" + name + ".gp", text);
    files.insert(files.end(), {csv, folder + "/" + name + ".gp"});
    return name;
}

}  // namespace mpm
