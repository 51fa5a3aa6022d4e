/// The gallery: one static HTML page with every figure, the commands behind it and what they reached.
#pragma once
#include <string>
#include <vector>

namespace mpm {

struct GalleryFigure {
    std::string name;               // name.png, in the folder of the figures
    std::vector<std::string> runs;  // folders below data/, patterns of the shell allowed; empty: those that the recipe names
    std::string caption;            // empty: the comment at the head of the recipe
};
struct GalleryChapter {
    std::string title;
    std::vector<GalleryFigure> figures;
};

/// Reads the list of chapters and figures: `# title` begins a chapter, `name | runs | caption` is a figure, the last two may be left out.
/// Throws FileTrouble, with the line.
std::vector<GalleryChapter> read_gallery(const std::string& path);

/// The comment at the head of a recipe, as one line; and the folders below data/ that it names, as patterns ("segment-*").
std::string recipe_caption(const std::string& text);
std::vector<std::string> recipe_runs(const std::string& text);

/// One line of a figure's table: a run, or one variant of a comparison.
struct GalleryRun {
    std::string command, csv;                                       // csv: relative to the folder of the figures
    std::string cells, error_name, error, order, seconds, verdict;  // of the finest resolution; empty where a run has no summary
};

/// What the runs of a figure reached. Throws FileTrouble where a pattern fits no folder of figures/data.
std::vector<GalleryRun> runs_of(const std::string& figures, const GalleryFigure& figure);

/// Writes figures/index.html. Throws FileTrouble where a figure, what it was made of, or what draws it again is missing.
void write_gallery(const std::string& plots, const std::string& figures);

}  // namespace mpm
