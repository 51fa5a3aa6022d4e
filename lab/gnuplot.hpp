/// Pieces of gnuplot scripts. For lab/figure.cpp, lab/particle_figure.cpp and plots/ only.
#pragma once
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mpm::detail {

using Replacements = std::vector<std::pair<std::string_view, std::string_view>>;
std::string replaced(std::string_view text, const Replacements& pairs);
/// A gnuplot string in which nothing is special.
std::string in_gnuplot(std::string_view text);
/// A text of the figure, as the script names it: with _ and ^ for indices and powers, unless it is plain, and its own form for LaTeX.
std::string label(const std::string& text, bool plain = false);
/// A column by name, as `using` takes it.
std::string column(const std::string& name);

/// Writes folder/name.gp whole or not at all. Throws FileTrouble.
std::string write_script(const std::string& folder, const std::string& name, const std::function<void(std::ostream&)>& body);
/// First lines of a script that draws every kind: what it draws, the kind, encoding, separator of columns.
std::string script_start(const std::string& name);
/// The terminal of the kind and its output; width and height in pixels, as numbers or as gnuplot's expressions.
std::string script_terminal(const std::string& name, const std::string& width, const std::string& height);

/// The scale of colours from c1 to c2, gnuplot's variables, for a column.
std::string colour_scale(const std::string& column, const std::string& label);

}  // namespace mpm::detail
