#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <utility>

#include "lab/options.hpp"
#include "plots/findings.hpp"
#include "plots/html.hpp"
#include "plots/notes.hpp"

namespace mpm {
namespace fs = std::filesystem;
namespace {

/// One compared case: data/atlas-NAME.
struct Case {
    std::string id, title, error, kind;
    std::vector<Finding> found;
};

std::string number(double x, const char* format = "%.2g") {
    if (std::isnan(x)) return "";
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

std::string percent(double error) { return number(100 * error, "%.2g") + " %"; }

std::vector<Case> read_cases(const fs::path& data) {
    std::vector<Case> cases;
    if (!fs::is_directory(data)) return cases;
    for (const auto& entry : fs::directory_iterator(data)) {
        Case c{entry.path().filename(), "", "", "", {}};
        if (!c.id.starts_with("atlas-")) continue;
        std::istringstream lines(read_file(entry.path() / "title"));
        for (std::string* line : {&c.title, &c.error, &c.kind}) std::getline(lines, *line);
        c.found = findings(read_csv(entry.path() / "errors.csv"));
        cases.push_back(std::move(c));
    }
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return std::pair(a.kind, a.id) < std::pair(b.kind, b.id); });
    return cases;
}

/// The variant that is as good as a level in the least time.
std::string fastest(const std::vector<Finding>& found, std::size_t level) {
    const Finding* first = nullptr;
    for (const Finding& f : found)
        if (!std::isnan(f.levels[level].seconds) && (first == nullptr || f.levels[level].seconds < first->levels[level].seconds))
            first = &f;
    if (first == nullptr) return "<td>none</td>";
    const Reached& run = first->levels[level];
    return "<td><b>" + html(first->name) + "</b><br>" + number(run.seconds) + " s, " + std::to_string(run.cells) + " cells</td>";
}

std::string most_accurate(const std::vector<Finding>& found) {
    const auto best = std::min_element(found.begin(), found.end(), [](const Finding& a, const Finding& b) {
        return a.finest.error < b.finest.error || (std::isnan(b.finest.error) && !std::isnan(a.finest.error));
    });
    if (best == found.end() || std::isnan(best->finest.error)) return "<td>none</td>";
    return "<td><b>" + html(best->name) + "</b><br>" + percent(best->finest.error) + " in " + number(best->finest.seconds) + " s, " +
           std::to_string(best->finest.cells) + " cells</td>";
}

/// One line for each case, by classes of problems: whom to take for an error that is wanted, and whom to leave.
std::string overview(const std::vector<Case>& cases) {
    std::string text = "<table class=\"overview\"><thead><tr><th>case</th>", kind;
    for (const double level : error_levels) text += "<th>fastest to " + number(100 * level, "%g") + " %</th>";
    text += "<th>most accurate</th><th>did not end well</th></tr></thead><tbody>\n";
    for (const Case& c : cases) {
        if (c.kind != kind) text += "<tr><th colspan=\"6\" class=\"class\">" + html(kind = c.kind) + "</th></tr>\n";
        text += "<tr><td><a href=\"#" + html(c.id) + "\">" + html(c.title) + "</a></td>";
        for (std::size_t level = 0; level < error_levels.size(); ++level) text += fastest(c.found, level);
        text += most_accurate(c.found) + "<td class=\"bad\">";
        const char* between = "";
        for (const Finding& f : c.found)
            if (!f.trouble.empty()) text += std::exchange(between, "<br>") + html(f.name + ": " + f.trouble);
        text += "</td></tr>\n";
    }
    return text + "</tbody></table>\n";
}

std::string table_of(const std::vector<Finding>& found) {
    std::string text = "<table><thead><tr><th>variant; * is beaten by no other</th><th class=\"number\">smallest error</th>";
    text += "<th class=\"number\">in seconds</th><th class=\"number\">cells</th>";
    for (const double level : error_levels) text += "<th class=\"number\">seconds to " + number(100 * level, "%g") + " %</th>";
    text += "<th>trouble</th></tr></thead><tbody>\n";
    for (const Finding& f : found) {
        text += "<tr><td>" + html((f.best ? "* " : "") + f.name) + "</td>" + html_cell(number(f.finest.error, "%.3g")) +
                html_cell(number(f.finest.seconds, "%.3g")) + html_cell(f.finest.cells > 0 ? std::to_string(f.finest.cells) : "");
        for (const Reached& run : f.levels) text += html_cell(number(run.seconds, "%.3g"));
        text += html_cell(f.trouble, "bad") + "</tr>\n";
    }
    return text + "</tbody></table>\n";
}

/// A case's pictures, what they were made with and what each variant reached.
std::string case_html(const fs::path& data, const Case& c) {
    const std::string below = "data/" + c.id + "/";
    std::string text = "<figure id=\"" + html(c.id) + "\">\n<figcaption><b>" + html(c.title) + "</b>, error " + html(c.error) + "; ";
    const std::pair<const char*, const char*> links[] = {{"compare.csv", "all rows"},
                                                         {"front.csv", "beaten by none"},
                                                         {"work_precision.gp", "script of the left"},
                                                         {"convergence.gp", "right picture"}};
    for (const auto& [file, what] : links)
        if (fs::exists(data / c.id / file)) text += "<a href=\"" + html(below + file) + "\">" + what + "</a>; ";
    text += "<code>make atlas</code></figcaption>\n";
    for (const auto& [picture, kind] : {std::pair("work_precision.png", "large"), std::pair("convergence.png", "small")})
        if (fs::exists(data / c.id / picture))
            text += "<a href=\"" + html(below + picture) + "\"><img class=\"" + kind + "\" src=\"" + html(below + picture) + "\" alt=\"" +
                    html(c.title) + ", " + picture + "\"></a>\n";
    if (fs::exists(data / c.id / "command"))
        text += "<p class=\"command\"><code>" + html(read_file(data / c.id / "command")) + "</code></p>\n";
    return text + table_of(c.found) + "</figure>\n";
}

std::string notes_of_chapters(const fs::path& chapters) {
    std::vector<fs::path> files;
    if (fs::is_directory(chapters))
        for (const auto& entry : fs::directory_iterator(chapters))
            if (fs::exists(entry.path() / "notes.md")) files.push_back(entry.path() / "notes.md");
    std::sort(files.begin(), files.end());
    std::string text;
    for (const fs::path& file : files)
        text += "<section id=\"notes-" + html(file.parent_path().filename()) + "\">\n" + notes_html(read_file(file)) + "</section>\n";
    return text;
}

}  // namespace

void write_findings(const std::string& chapters, const std::string& figures) {
    const fs::path data = fs::path(figures) / "data";
    const std::vector<Case> cases = read_cases(data);
    std::string body =
        "<h1>What to use when</h1>\n<p><a href=\"index.html\">All figures</a> &middot; <a href=\"#notes\">Notes of the chapters</a></p>\n";
    if (cases.empty())
        body +=
            "<p><code>make atlas</code> compares the variants of every case that has an exact or a reference solution and writes here "
            "which to take.</p>\n";
    else
        body +=
            "<p>Every case that has an exact or a reference solution, run by the variants that can run it at several resolutions. Seconds "
            "are "
            "CPU seconds of the method on the machine that drew this page: their ratios tell, not their values. Made from the "
            "<code>errors.csv</code> of each case.</p>\n" +
            overview(cases);
    for (const Case& c : cases) body += case_html(data, c);
    body += "<h1 id=\"notes\">Notes of the chapters</h1>\n" + notes_of_chapters(chapters);
    write_page(figures + "/findings.html", "MPM Lab: what to use when", body);
}

}  // namespace mpm
