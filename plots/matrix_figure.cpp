#include "plots/matrix_figure.hpp"

#include <algorithm>
#include <cmath>

#include "lab/record.hpp"
#include "plots/script.hpp"

namespace mpm {
namespace {

constexpr int row_height = 36, column_width = 104, left_width = 400, line_height = 27;

/// "1e4" as 10^4, 2^-8 with its exponent raised; other texts as they are.
std::string value_text(const std::string& value) {
    if (const std::size_t hat = value.find('^'); hat != std::string::npos) {
        const std::string raised = value.substr(0, hat) + "^{" + value.substr(hat + 1) + "}";
        return formula(raised, "$" + raised + "$");
    }
    const std::size_t e = value.find("1e");
    if (e == std::string::npos) return plain(value);
    std::size_t end = e + 2;
    while (end < value.size() && (std::isdigit(static_cast<unsigned char>(value[end])) != 0 || value[end] == '-')) ++end;
    const std::string power = value.substr(e + 2, end - e - 2), before = value.substr(0, e), after = value.substr(end);
    return power.empty() ? plain(value) : formula(before + "10^{" + power + "}" + after, before + "$10^{" + power + "}$" + after);
}

/// Text in lines of at most so many letters.
std::vector<std::string> wrapped(const std::string& text, int letters) {
    std::vector<std::string> lines(1);
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find(' ', from), text.size());
        const std::string word = text.substr(from, end - from);
        if (lines.back().size() + word.size() + 1 > static_cast<std::size_t>(letters)) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
        from = end + 1;
    }
    return lines;
}

/// Shade of a cell between 0 and 1: decades of the error from 1e-6 to 1; of a largest step from 0.1 to 10.
double shade(const Cell& cell) {
    if (!std::isfinite(cell.error)) return 0;
    const double decades = std::log10(std::max(cell.error, 1e-300));
    return std::clamp(cell.kind == "limit" ? 0.5 - decades / 2 : 1 + decades / 6, 0.0, 1.0);
}

std::string labels(const std::vector<ExtremeCase>& cases) {
    std::string text;
    for (std::size_t r = 0; r < cases.size(); ++r) {
        const std::string at = " right at graph -0.012, first " + std::to_string(r + 1) + "\n";
        text += "set label " + value_text(cases[r].value) + at;
        if (r == 0 || cases[r].group != cases[r - 1].group) {
            text += "set label " + plain(cases[r].group) + " left at screen 0.008, first " + std::to_string(r + 1) + "\n";
            if (r > 0)
                text += "set arrow from screen 0.008, first " + std::to_string(r) + ".5 to graph 1, first " + std::to_string(r) +
                        ".5 nohead lw 1.5 lc rgb '#404040' front\n";
        }
    }
    return text;
}

std::string heads(const std::vector<CaseColumn>& columns) {
    std::string text;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const std::size_t space = columns[c].shown.find(' ');
        const std::string above = columns[c].shown.substr(0, space),
                          below = space == std::string::npos ? "" : columns[c].shown.substr(space + 1);
        const std::string latex = gnuplot_text("\\shortstack{" + above + "\\\\" + below + "}");
        text += (c > 0 ? ", " : "") + std::string("(tex ? ") + latex + " : \"" + above + "\\n" + below + "\") " + std::to_string(c + 1);
    }
    return "set x2tics (" + text + ") scale 0 font ',16'\n";
}

}  // namespace

std::string Footnotes::letter(const std::string& reason) {
    auto at = std::find(reasons.begin(), reasons.end(), reason);
    if (at == reasons.end()) at = reasons.insert(at, reason);
    const auto number = static_cast<std::size_t>(at - reasons.begin());
    return std::string(number >= 26 ? 1 : 0, 'a') + static_cast<char>('a' + number % 26);
}

std::string text_of(const Cell& cell, Footnotes& notes) {
    if (cell.kind == "none") return notes.letter(cell.reason);
    return cell.known.empty() ? cell.shown() : cell.shown() + " (" + notes.letter(cell.known) + ")";
}

std::string write_matrix(const std::string& folder, const CaseTable& table, const std::vector<ExtremeCase>& cases,
                         const std::vector<std::vector<Cell>>& cells, std::vector<std::string>& files) {
    const std::string name = table.name, csv = folder + "/" + name + ".csv";
    Footnotes notes;
    {
        CsvFile file(csv, {"row", "column", "kind", "level", "ink", "shown"});
        for (std::size_t r = 0; r < cells.size(); ++r)
            for (std::size_t c = 0; c < cells[r].size(); ++c) {
                const Cell& cell = cells[r][c];
                const bool dark = cell.kind == "unstable" || cell.kind == "failed";
                file.row({std::to_string(r + 1), std::to_string(c + 1), cell.kind == "limit" ? "error" : cell.kind,
                          number_text(shade(cell)), dark ? "16777215" : "0", text_of(cell, notes)});
            }
    }
    const bool steps = std::all_of(cases.begin(), cases.end(), [](const ExtremeCase& c) { return c.kind == ExtremeCase::Kind::limit; });
    const int rows = static_cast<int>(cells.size()), columns = static_cast<int>(table.columns.size());
    const int width = std::max(left_width + column_width * columns + 30, 1000);
    std::vector<std::string> below;
    const auto add_below = [&](const std::string& text) {
        for (const std::string& line : wrapped(text, width / 10)) below.push_back(line);
    };
    add_below(
        steps ? "Number: the largest stable step found, as a fraction of the critical one. Dark: no stable step. Letter: not offered."
              : "Number: the error reached. Dark: the named instability that ended the run. Orange: over the bound of the case, for "
                "the reason in brackets. Letter: not offered.");
    for (const std::string& reason : notes.reasons) add_below(notes.letter(reason) + ": " + reason);
    const std::vector<std::string> title = wrapped(table.title, width / 13);
    const int under = line_height * static_cast<int>(below.size()) + 30, over = 32 * static_cast<int>(title.size()) + 14;
    const int top = over + 78, height = top + row_height * rows + under;
    std::string text = script_head(name, width, height, "") + "unset title\n";
    const auto screen = [](double part, double of) { return number_text(part / of); };
    text += "set lmargin at screen " + screen(left_width, width) + "\nset rmargin at screen " +
            screen(left_width + column_width * columns, width) + "\nset bmargin at screen " + screen(under, height) +
            "\nset tmargin at screen " + screen(height - top, height) + "\n";
    text += "set xrange [0.5:" + std::to_string(columns) + ".5]\nset x2range [0.5:" + std::to_string(columns) + ".5]\nset yrange [" +
            std::to_string(rows) + ".5:0.5]\nunset xtics\nunset ytics\nunset grid\nunset key\nunset colorbox\nset cbrange [0:1]\n";
    text += "set palette defined (0 '#f7fbff', 0.5 '#a6cde5', 1 '#4a90c4')\n" + heads(table.columns) + labels(cases);
    for (std::size_t i = 0; i < title.size(); ++i)
        text += "set label " + plain(title[i]) + " left at screen 0.008, screen " +
                screen(height - 32 * (static_cast<double>(i) + 0.8), height) + "\n";
    for (std::size_t i = 0; i < below.size(); ++i)
        text += "set label " + plain(below[i]) + " left at screen 0.008, screen " +
                screen(under - 16 - line_height * (static_cast<double>(i) + 0.5), height) + " font ',14'\n";
    const auto only = [](const std::string& kind) { return "(strcol('kind') eq '" + kind + "' ? column('column') : NaN)"; };
    const std::string box = ":(column('row')):(0.5):(0.5)", source = "'" + name + ".csv' using ";
    text += "set style fill solid 1 border lc rgb '#808080'\nplot " + source + only("error") + box +
            ":(column('level')) with boxxyerror fc palette, \\\n     " + source + only("unstable") + box +
            " with boxxyerror fc rgb '#303030', \\\n     " + source + only("failed") + box +
            " with boxxyerror fc rgb '#a00000', \\\n     " + source + only("inaccurate") + box +
            " with boxxyerror fc rgb '#f5a040', \\\n     " + source + only("none") + box + " with boxxyerror fc rgb 'white', \\\n     " +
            source + "(column('column')):(column('row')):(strcol('shown')):(column('ink')) with labels tc rgb variable font "
            "',15' noenhanced\n";
    write_file(folder + "/" + name + ".gp", text);
    files.insert(files.end(), {csv, folder + "/" + name + ".gp"});
    return name;
}

}  // namespace mpm
