/// gnuplot scripts of plots/: what lab/figure.hpp does not draw (logarithmic axes, markers, maps). One script draws png, svg, pdf or LaTeX.
#pragma once
#include <string>
#include <vector>

namespace mpm {

/// A gnuplot string in which nothing is special.
std::string gnuplot_text(const std::string& text);
/// A plain text (names of programs, options) which gnuplot and LaTeX show as it stands.
std::string plain(const std::string& text);
/// A text with _ ^ {} and its own form for LaTeX.
std::string formula(const std::string& text, const std::string& latex);

/// The lines before anything is plotted: terminal by `kind`, size in pixels, encoding, grid, title. `name` is that of the figure.
std::string script_head(const std::string& name, int width, int height, const std::string& title);

/// Line and marker of the n-th curve: colours that differ in lightness, dashes and shapes, so that curves can be told apart without colour.
/// `thin`: one that steps back behind others.
std::string curve_style(std::size_t n, bool thin = false);

/// The legend below the plot, one name a line, so that long names do not squeeze it; and the pixels that it takes.
constexpr const char* legend = "set key below left Left reverse height 0.6 maxcols 1\n";
int legend_height(std::size_t entries);
/// The same, in two columns where there are many names and all are short; and the lines that it takes.
std::string legend_of(const std::vector<std::string>& names, std::size_t& lines);

/// "set xtics (...)" of a logarithmic axis, and its range: decades or, over a short range, 1, 2, 5.
std::string log_axis(char axis, double low, double high);
/// The same with tics at these values only.
std::string log_axis(char axis, const std::vector<double>& values);

}  // namespace mpm
