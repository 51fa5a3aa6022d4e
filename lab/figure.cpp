#include "lab/figure.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <ostream>

#include "lab/gnuplot.hpp"
#include "lab/record.hpp"

namespace mpm {

using namespace detail;

namespace {

/// Colours that differ in lightness, each with its own dash, so that curves can be told apart in print without colour.
constexpr std::size_t line_type_count = 6;
constexpr const char* line_types = R"(set linetype 1 lc rgb '#000000' lw 2.5 dt solid
set linetype 2 lc rgb '#d55e00' lw 2.5 dt (8,3)
set linetype 3 lc rgb '#0072b2' lw 2.5 dt (2,4)
set linetype 4 lc rgb '#e69f00' lw 2.5 dt solid
set linetype 5 lc rgb '#009e73' lw 2.5 dt (8,3,2,3)
set linetype 6 lc rgb '#cc79a7' lw 2.5 dt (14,3)
)";

/// From light to dark, so that it prints without colour.
constexpr const char* surface_style = R"(set xyplane relative 0
set view 60,35,1.06,1.4
unset key
unset colorbox
set xlabel offset 0,-0.5
set ylabel offset 0,-0.5
set xtics 1 offset 0,-0.3
set ytics 1 offset 0.5,-0.3
set palette defined (0 '#ffffe5', 0.25 '#c7e9b4', 0.5 '#41b6c4', 0.75 '#225ea8', 1 '#081d58')
set pm3d depthorder border lc rgb '#404040' lw 0.4
)";

void surface(std::ostream& s, const Panel& p, const std::string& csv) {
    const std::string rows = std::to_string(p.surface_rows);
    s << surface_style << "set dgrid3d " << rows << "," << rows
      << " qnorm 8  # the points are on this square already: heights stay as they are\n"
      << "splot " << in_gnuplot(csv) << " using " << column(p.x) << ":" << column(p.surface_y) << ":" << column(p.curves.front().y)
      << " with pm3d notitle\nunset dgrid3d\n";
}

void curves(std::ostream& s, const Panel& p, const std::string& csv) {
    s << "set xrange " << (p.x_range.empty() ? "[*:*]" : p.x_range)
      << "\nset yrange " << (p.y_range.empty() ? "[*:*]" : p.y_range) << "\nplot ";
    for (std::size_t i = 0; i < p.curves.size(); ++i) {
        const Curve& c = p.curves[i];
        s << (i > 0 ? ", \\\n     " : "") << in_gnuplot(csv) << " using " << column(p.x) << ":" << column(c.y) << " with " << c.style
          << (c.style == "lines" ? " lt " + std::to_string(i % line_type_count + 1) : " lw 2") << " title " << label(c.title);
    }
    s << "\n";
}

/// The lines before anything is plotted.
void head(std::ostream& s, const std::string& name, int width, int height) {
    s << script_start(name) << script_terminal(name, std::to_string(width), std::to_string(height))
      << "set grid lc rgb '#dddddd' lt 1 lw 1\n"
      << line_types;
}

std::string in_shell(const std::string& word) { return std::string("'").append(replaced(word, {{"'", "'\\''"}})) + "'"; }

}  // namespace

std::string write_figure(const std::string& folder, const std::string& name, const std::string& csv, const std::string& title,
                         const std::vector<Panel>& panels, int columns) {
    const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    const int width = columns == 1 ? 1200 : 750 * columns, height = (columns == 1 ? 480 : 460) * rows + 40;
    return write_script(folder, name, [&](std::ostream& s) {
        head(s, name, width, height);
        s << (columns == 1 ? "set key outside top center horizontal\nset lmargin 11\nset rmargin 4\n"
                           : "set key outside right top samplen 1.5\nset offsets graph 0, 0, 0.04, 0.04\n")
          << "set multiplot layout " << rows << "," << columns << " title " << label(title, true)
          << (columns == 1 ? ".(tex ? '' : \"\\n \")" : "") << " noenhanced\n";
        for (const Panel& p : panels) {
            s << "set title " << label(p.title) << "\nset xlabel " << label(p.x_label) << "\nset ylabel " << label(p.y_label) << "\n";
            const std::string file = p.csv.empty() ? csv : p.csv;
            p.surface_y.empty() ? curves(s, p, file) : surface(s, p, file);
        }
        s << "unset multiplot\n";
    });
}

std::string write_drawing(const std::string& folder, const std::string& name, int width, int height, const std::string& body) {
    return write_script(folder, name, [&](std::ostream& s) {
        head(s, name, width, height);
        s << body;
    });
}

std::string draw_figure(const std::string& folder, const std::string& name, const std::string& kind, std::string& why) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) return why = "gnuplot is not installed (package gnuplot-nox)", "";
    const std::string command =
        "cd -- " + in_shell(folder) + " && gnuplot -e \"kind='" + kind + "'\" " + in_shell(name + ".gp") + " >gnuplot.log 2>&1";
    if (std::system(command.c_str()) != 0) return why = "gnuplot failed, see " + folder + "/gnuplot.log", "";
    std::error_code ignored;
    std::filesystem::remove(folder + "/gnuplot.log", ignored);
    return folder + "/" + name + "." + (kind == "tikz" ? "tex" : kind);
}

void add_picture(const std::string& folder, const std::string& name, const std::string& kind, std::vector<std::string>& files) {
    if (kind == "none") return;
    std::string why;
    const std::string picture = draw_figure(folder, name, kind, why);
    if (picture.empty())
        std::fprintf(stderr, "no picture: %s\n", why.c_str());
    else
        files.push_back(picture);
}

}  // namespace mpm
