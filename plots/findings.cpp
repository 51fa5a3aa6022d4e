#include "plots/findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <regex>
#include <sstream>

#include "lab/options.hpp"
#include "plots/html.hpp"

namespace mpm {
namespace fs = std::filesystem;
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Outcome {
    std::size_t variant;
    double error, seconds;
};

bool beaten(const Outcome& one, const std::vector<Outcome>& all) {
    return std::any_of(all.begin(), all.end(), [&](const Outcome& other) {
        return other.error <= one.error && other.seconds <= one.seconds && (other.error < one.error || other.seconds < one.seconds);
    });
}

std::string number(double x, const char* format) {
    if (std::isnan(x)) return "";
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

std::string table_of(const std::vector<Finding>& found) {
    std::string text = "<table><thead><tr><th>variant; * is beaten by no other</th><th>smallest error</th><th>in seconds</th>";
    for (const double level : error_levels) text += "<th>seconds to " + number(100 * level, "%g") + " %</th>";
    text += "<th>trouble</th></tr></thead><tbody>\n";
    for (const Finding& f : found) {
        text += "<tr><td>" + html((f.best ? "* ./" : "./") + f.command) + "</td>" + html_cell(number(f.error, "%.3g")) +
                html_cell(number(f.seconds, "%.3g"));
        for (const double seconds : f.reached) text += html_cell(number(seconds, "%.3g"));
        text += html_cell(f.trouble, "bad") + "</tr>\n";
    }
    return text + "</tbody></table>\n";
}

}  // namespace

std::string command_of(const CsvTable& rows, std::size_t row) {
    std::string command = rows.text(row, "program");
    const std::string options = std::regex_replace(rows.text(row, "options"), std::regex("(^|;)cells=[^;]*"), "");
    std::istringstream items(options);
    for (std::string item; std::getline(items, item, ';');) {
        if (item.empty()) continue;
        const std::size_t is = item.find('=');
        command += " --" + item.substr(0, is);
        if (is != std::string::npos && item.substr(is) != "=true") command += " " + item.substr(is + 1);
    }
    return command;
}

std::vector<Finding> findings(const CsvTable& rows, const std::string& error_name) {
    std::vector<Finding> found;
    std::vector<Outcome> all;
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
        if (rows.text(row, "error_name") != (error_name.empty() ? rows.text(0, "error_name") : error_name)) continue;
        const std::string command = command_of(rows, row);
        auto same = std::find_if(found.begin(), found.end(), [&](const Finding& f) { return f.command == command; });
        if (same == found.end()) same = found.insert(found.end(), Finding{command, nan, nan, {nan, nan, nan}, false, ""});
        const double error = std::abs(rows.number(row, "error")), seconds = rows.number(row, "wall_s");
        if (rows.text(row, "verdict") != "ok") same->trouble = rows.text(row, "verdict");
        if (rows.text(row, "verdict") != "ok" || std::isnan(error) || std::isnan(seconds)) continue;
        all.push_back({static_cast<std::size_t>(same - found.begin()), error, seconds});
        if (!(same->error <= error)) same->error = error, same->seconds = seconds;
        for (std::size_t i = 0; i < error_levels.size(); ++i)
            if (error <= error_levels[i] && !(same->reached[i] <= seconds)) same->reached[i] = seconds;
    }
    for (const Outcome& one : all)
        if (!beaten(one, all)) found[one.variant].best = true;
    std::stable_sort(found.begin(), found.end(), [](const Finding& a, const Finding& b) {
        if (a.best != b.best) return a.best;
        return a.error < b.error || (std::isnan(b.error) && !std::isnan(a.error));
    });
    return found;
}

std::string findings_html(const std::string& figures) {
    std::vector<fs::path> folders;
    if (fs::is_directory(fs::path(figures) / "data"))
        for (const auto& entry : fs::directory_iterator(fs::path(figures) / "data"))
            if (entry.path().filename().string().starts_with("atlas-")) folders.push_back(entry.path());
    if (folders.empty()) return "";
    std::sort(folders.begin(), folders.end());
    std::string text =
        "<h2 id=\"findings\">What to use when</h2>\n<p>Every case that has an exact or a reference solution, with the variants that can "
        "run it, at several "
        "resolutions: the smallest error that each reached, and the seconds in which it was as good as 1 %, 0.1 % and 0.01 %.</p>\n";
    for (const fs::path& folder : folders) {
        std::istringstream title(read_file(folder / "title"));
        std::string name, error;
        std::getline(title, name);
        std::getline(title, error);
        const std::string below = fs::relative(folder, figures).string() + "/";
        text += "<figure id=\"" + html(folder.filename().string()) + "\">\n<figcaption><b>" + html(name) + "</b>, error " + html(error) +
                ": <a href=\"" + html(below) + "compare.csv\">all rows</a></figcaption>\n";
        for (const char* picture : {"work_precision.png", "convergence.png"})
            if (fs::exists(folder / picture))
                text += "<a href=\"" + html(below + picture) + "\"><img class=\"half\" src=\"" + html(below + picture) + "\" alt=\"" +
                        picture + "\"></a>\n";
        text += table_of(findings(read_csv(folder / "compare.csv"), error)) + "</figure>\n";
    }
    return text;
}

}  // namespace mpm
