#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lab/csv_read.hpp"
#include "lab/options.hpp"
#include "plots/findings.hpp"
#include "plots/gallery.hpp"
#include "plots/html.hpp"

namespace mpm {
namespace fs = std::filesystem;
namespace {

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \t\r");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

std::string row(const GalleryRun& run) {
    const std::string command = html("./" + run.command);
    std::string text = "<tr><td>" + (run.csv.empty() ? command : "<a href=\"" + html(run.csv) + "\">" + command + "</a>") + "</td>";
    text += html_cell(run.cells) + html_cell(run.error_name, "name") + html_cell(run.error) + html_cell(run.order) + html_cell(run.seconds);
    return text + html_cell(run.verdict, run.verdict.empty() || run.verdict == "ok" ? "name" : "bad") + "</tr>\n";
}

/// The figure's recipe, relative to the figures: its copy, or the script that the program has left beside its data.
std::string script_of(const fs::path& figures, const GalleryFigure& figure) {
    std::vector<std::string> places{figure.name + ".gp"};
    for (const std::string& run : figure.runs) {
        places.push_back("data/" + run + "/" + figure.name + ".gp");
        const std::size_t prefix = figure.name.find(run + "_");  // segment_convergence of data/segment
        if (prefix == 0) places.push_back("data/" + run + "/" + figure.name.substr(run.size() + 1) + ".gp");
    }
    for (const std::string& place : places)
        if (fs::exists(figures / place)) return place;
    throw FileTrouble(figure.name + ": nothing draws it again, neither a recipe nor a script beside its data");
}

std::string figure_html(const fs::path& figures, const GalleryFigure& figure) {
    std::string picture = figure.name + ".png";
    if (!fs::exists(figures / picture)) picture = figure.name + ".gif";
    if (!fs::exists(figures / picture))
        throw FileTrouble((figures / figure.name).string() + ": the gallery lists it, but it was not drawn");
    const std::vector<GalleryRun> runs = runs_of(figures, figure);
    const bool errors = std::any_of(runs.begin(), runs.end(), [](const GalleryRun& run) { return !run.error.empty(); });
    std::string text = "<figure id=\"" + html(figure.name) + "\">\n<a href=\"" + html(picture) + "\"><img src=\"" + html(picture) +
                       "\" alt=\"" + html(figure.name) + "\"></a>\n<figcaption>" + html(figure.caption) + " <a href=\"" +
                       html(script_of(figures, figure)) + "\">gnuplot script</a></figcaption>\n";
    if (runs.empty()) return text + "</figure>\n";
    text += "<table><thead><tr><th>command, with a link to its data</th><th>cells</th><th>error of the finest</th><th>";
    text += std::string(errors ? "value" : "") + "</th><th>order</th><th>seconds</th><th>verdict</th></tr></thead><tbody>\n";
    for (const GalleryRun& run : runs) text += row(run);
    return text + "</tbody></table>\n</figure>\n";
}

void complete(GalleryFigure& figure, const fs::path& plots) {
    const fs::path recipe = plots / (figure.name + ".gp");
    if (!fs::exists(recipe)) return;
    const std::string text = read_file(recipe);
    if (figure.caption.empty()) figure.caption = recipe_caption(text);
    if (figure.runs.empty()) figure.runs = recipe_runs(text);
}

void check_all_listed(const fs::path& plots, const std::vector<GalleryChapter>& chapters) {
    for (const auto& entry : fs::directory_iterator(plots)) {
        if (entry.path().extension() != ".gp") continue;
        const std::string name = entry.path().stem();
        bool listed = false;
        for (const GalleryChapter& chapter : chapters)
            listed |= std::any_of(chapter.figures.begin(), chapter.figures.end(), [&](const GalleryFigure& f) { return f.name == name; });
        if (!listed) throw FileTrouble((plots / "gallery.txt").string() + ": recipe " + name + ".gp is missing from the list");
    }
}

}  // namespace

std::vector<GalleryChapter> read_gallery(const std::string& path) {
    std::istringstream lines(read_file(path));
    std::vector<GalleryChapter> chapters;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        line = trimmed(line);
        if (line.empty()) continue;
        if (line[0] == '#') {
            chapters.push_back({trimmed(line.substr(1)), {}});
            continue;
        }
        if (chapters.empty()) throw FileTrouble(path + ":" + std::to_string(number) + ": a figure before the first chapter");
        std::istringstream parts(line);
        GalleryFigure figure;
        std::string runs;
        std::getline(parts, figure.name, '|');
        std::getline(parts, runs, '|');
        std::getline(parts, figure.caption);
        figure.name = trimmed(figure.name);
        figure.caption = trimmed(figure.caption);
        std::istringstream words(runs);
        for (std::string word; words >> word;) figure.runs.push_back(word);
        chapters.back().figures.push_back(std::move(figure));
    }
    return chapters;
}

void write_gallery(const std::string& plots, const std::string& figures) {
    std::vector<GalleryChapter> chapters = read_gallery(plots + "/gallery.txt");
    check_all_listed(plots, chapters);
    std::string page =
        "<h1>MPM Lab: the gallery</h1>\n<p>Every figure, the commands that made its data, and the error and run time of the finest "
        "resolution. A script draws its figure again: <code>gnuplot name.gp</code> in this folder. Which variant is the best for a "
        "problem: "
        "<a href=\"findings.html\">what to use when</a>.</p>\n<nav>\n";
    for (std::size_t c = 0; c < chapters.size(); ++c)
        page += "<a href=\"#chapter-" + std::to_string(c + 1) + "\">" + html(chapters[c].title) + "</a>\n";
    page += "<a href=\"findings.html\">What to use when</a>\n</nav>\n";
    for (std::size_t c = 0; c < chapters.size(); ++c) {
        page += "<h2 id=\"chapter-" + std::to_string(c + 1) + "\">" + html(chapters[c].title) + "</h2>\n";
        for (GalleryFigure& figure : chapters[c].figures) {
            complete(figure, plots);
            page += figure_html(figures, figure);
        }
    }
    write_findings(plots + "/../chapters", figures);
    write_page(figures + "/index.html", "MPM Lab: the gallery", page);
}

}  // namespace mpm
