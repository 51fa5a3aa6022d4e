#include <fnmatch.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <regex>

#include "lab/csv_read.hpp"
#include "lab/options.hpp"
#include "plots/findings.hpp"
#include "plots/gallery.hpp"

namespace mpm {
namespace fs = std::filesystem;
namespace {

std::string short_number(const CsvTable& table, std::size_t row, const char* column, const char* format) {
    const double x = table.number(row, column);
    if (x != x) return "";
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// The finest resolution of each variant in a table of summary rows, by the first error that the table names.
std::vector<GalleryRun> finest(const CsvTable& table, const std::string& csv) {
    std::vector<GalleryRun> found;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.text(row, "error_name") != table.text(0, "error_name")) continue;
        GalleryRun run{command_of(table, row),
                       csv,
                       table.text(row, "cells"),
                       table.text(row, "error_name"),
                       short_number(table, row, "error", "%.3g"),
                       short_number(table, row, "order", "%.2f"),
                       short_number(table, row, "wall_s", "%.3g"),
                       table.text(row, "verdict")};
        const auto same = std::find_if(found.begin(), found.end(), [&](const GalleryRun& other) { return other.command == run.command; });
        if (same == found.end())
            found.push_back(std::move(run));
        else
            *same = std::move(run);
    }
    return found;
}

std::string first_csv(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".csv") names.push_back(entry.path().filename());
    if (names.empty()) return "";
    return *std::min_element(names.begin(), names.end());
}

std::vector<GalleryRun> runs_in(const fs::path& figures, const fs::path& folder) {
    const std::string below = fs::relative(folder, figures).string() + "/";
    if (fs::exists(folder / "compare.csv")) return finest(read_csv(folder / "compare.csv"), below + "compare.csv");
    std::string command = read_file(folder / "command");
    while (!command.empty() && command.back() == '\n') command.pop_back();
    if (!fs::exists(folder / "summary.csv")) {
        const std::string csv = first_csv(folder);
        return {{command, csv.empty() ? "" : below + csv, "", "", "", "", "", ""}};
    }
    std::vector<GalleryRun> runs = finest(read_csv(folder / "summary.csv"), below + "summary.csv");
    if (runs.size() == 1) runs[0].command = command;
    return runs;
}

}  // namespace

std::string recipe_caption(const std::string& text) {
    std::string caption;
    for (std::size_t at = 0; at < text.size() && text[at] == '#';) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::size_t from = std::min(text.find_first_not_of("# ", at), end);
        caption += (caption.empty() ? "" : " ") + text.substr(from, end - from);
        at = end + 1;
    }
    return caption;
}

std::vector<std::string> recipe_runs(const std::string& text) {
    static const std::regex named("data/([A-Za-z0-9_.-]*)(/?)");
    std::vector<std::string> runs;
    for (std::sregex_iterator it(text.begin(), text.end(), named), end; it != end; ++it) {
        const std::string run = (*it)[1].str() + ((*it)[2].length() ? "" : "*");
        if (run != "*" && std::find(runs.begin(), runs.end(), run) == runs.end()) runs.push_back(run);
    }
    return runs;
}

std::vector<GalleryRun> runs_of(const std::string& figures, const GalleryFigure& figure) {
    std::vector<std::string> folders;
    const fs::path data = fs::path(figures) / "data";
    if (fs::is_directory(data))
        for (const auto& entry : fs::directory_iterator(data)) folders.push_back(entry.path().filename());
    std::sort(folders.begin(), folders.end());
    std::vector<GalleryRun> runs;
    for (const std::string& pattern : figure.runs) {
        bool any = false;
        for (const std::string& folder : folders) {
            if (fnmatch(pattern.c_str(), folder.c_str(), 0) != 0) continue;
            any = true;
            for (GalleryRun& run : runs_in(figures, data / folder)) runs.push_back(std::move(run));
        }
        if (!any) throw FileTrouble(figure.name + ": no run fits data/" + pattern);
    }
    return runs;
}

}  // namespace mpm
