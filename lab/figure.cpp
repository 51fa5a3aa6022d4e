#include "lab/figure.hpp"

#include <gnuplot-iostream.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>

#include "lab/record.hpp"

namespace mpm {
namespace {

using Replacements = std::vector<std::pair<std::string_view, std::string_view>>;

std::string replaced(std::string_view text, const Replacements& pairs) {
    std::string result;
    while (!text.empty()) {
        const auto hit = std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return text.starts_with(pair.first); });
        result += hit != pairs.end() ? hit->second : text.substr(0, 1);
        text.remove_prefix(hit != pairs.end() ? hit->first.size() : 1);
    }
    return result;
}

/// A gnuplot string in which nothing is special.
std::string in_gnuplot(std::string_view text) { return std::string("'").append(replaced(text, {{"'", "''"}, {"\n", " "}})) + "'"; }

/// The same words for LaTeX: those with indices, powers or symbols become formulas, unless the text is plain.
std::string latex(std::string_view text, bool plain) {
    static const Replacements escapes{{"%", "\\%"}, {"&", "\\&"}, {"#", "\\#"}, {"_", "\\_"}, {"^", "\\^{}"}};
    static const Replacements symbols{{"φ", "\\phi "},   {"∂", "\\partial "}, {"∇", "\\nabla "}, {"σ", "\\sigma "}, {"ε", "\\varepsilon "},
                                      {"α", "\\alpha "}, {"ρ", "\\rho "},     {"−", "-"},        {"Σ", "\\Sigma "}, {"×", "\\times "}};
    std::string result;
    while (!text.empty()) {
        const std::size_t space = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, space);
        const bool formula = std::any_of(word.begin(), word.end(), [](char c) { return c == '_' || c == '^' || (c & 0x80) != 0; });
        result += formula && !plain ? std::string("$").append(replaced(word, symbols)).append("$") : replaced(word, escapes);
        text.remove_prefix(space);
        if (!text.empty()) result += ' ', text.remove_prefix(1);
    }
    return result;
}

/// A text of the figure, as the script names it.
std::string label(const std::string& text, bool plain = false) {
    const std::string formulas = latex(text, plain);
    return formulas == text ? in_gnuplot(text) : "(tex ? " + in_gnuplot(formulas) + " : " + in_gnuplot(text) + ")";
}

std::string column(const std::string& name) { return "(column(" + in_gnuplot(name) + "))"; }

/// Writes folder/name.gp whole or not at all: gnuplot-iostream fills the temporary name that replace_file gives.
std::string write_script(const std::string& folder, const std::string& name, const std::function<void(std::ostream&)>& body) {
    const std::string path = folder + "/" + name + ".gp";
    replace_file(path, [&](const std::string& part) {
        errno = 0;
        try {
            Gnuplot gp(">" + part);
            body(gp);
            if (gp.flush()) return 0;
        } catch (const std::ios_base::failure&) {  // the file could not be opened; errno says why
        }
        return errno != 0 ? errno : EIO;
    });
    return path;
}

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
    s << "set xrange " << (p.x_range.empty() ? "[*:*]" : p.x_range) << "\nplot ";
    for (std::size_t i = 0; i < p.curves.size(); ++i) {
        const Curve& c = p.curves[i];
        s << (i > 0 ? ", \\\n     " : "") << in_gnuplot(csv) << " using " << column(p.x) << ":" << column(c.y) << " with " << c.style
          << (c.style == "lines" ? " lt " + std::to_string(i % line_type_count + 1) : " lw 2") << " title " << label(c.title);
    }
    s << "\n";
}

/// The lines before anything is plotted.
void head(std::ostream& s, const std::string& name, int width, int height) {
    const auto size = [&](double unit) { return number_text(width * unit) + "," + number_text(height * unit); };
    s << "# gnuplot " << name << ".gp draws " << name << ".png; other kinds: gnuplot -e \"kind='svg'\" " << name << ".gp\n"
      << "if (!exists(\"kind\")) kind = 'png'\ntex = kind eq 'tikz'\nset encoding utf8\n"
      << "if (kind eq 'png') set terminal pngcairo size " << size(1) << " font ',18'\n"
      << "if (kind eq 'svg') set terminal svg size " << size(1) << " dynamic font 'sans-serif,18' background rgb 'white'\n"
      << "if (kind eq 'pdf') set terminal pdfcairo size " << size(0.005) << " font ',9'\n"
      << "if (tex) set terminal cairolatex pdf size " << size(0.005) << "\n"
      << "set output " << in_gnuplot(name + ".") << ".(tex ? 'tex' : kind)\n"
      << "set datafile separator ','\nset grid lc rgb '#dddddd' lt 1 lw 1\n"
      << line_types;
}

std::string in_shell(const std::string& word) { return "'" + replaced(word, {{"'", "'\\''"}}) + "'"; }

}  // namespace

std::string write_figure(const std::string& folder, const std::string& name, const std::string& csv, const std::string& title,
                         const std::vector<Panel>& panels, int columns) {
    const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    const int width = columns == 1 ? 1200 : 750 * columns, height = (columns == 1 ? 480 : 460) * rows + 40;
    return write_script(folder, name, [&](std::ostream& s) {
        head(s, name, width, height);
        s << (columns == 1 ? "set key outside right top\n" : "set key outside right top samplen 1.5\nset offsets graph 0, 0, 0.04, 0.04\n")
          << "set multiplot layout " << rows << "," << columns << " title " << label(title, true) << " noenhanced\n";
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

std::string Frame::file() const {
    char name[48];
    std::snprintf(name, sizeof name, "particles_%04ld.csv", number);
    return name;
}

std::vector<std::string> write_animation(const std::string& folder, const std::string& name, const std::string& title, const Animated& a,
                                         const std::vector<Frame>& frames) {
    const bool coloured = !a.colour.empty();
    const auto file = [](const std::string& number) { return "sprintf('particles_%04d.csv', " + number + ")"; };
    CsvFile list(folder + "/frames.csv", {"frame", "t", "file"});
    for (const Frame& frame : frames) list.row({std::to_string(frame.number), number_text(frame.t), frame.file()});
    const std::string xy = column(a.x) + ":" + column(a.y);
    const std::string script = write_script(folder, name, [&](std::ostream& s) {
        s << "# gnuplot " << name << ".gp draws " << name << ".gif from the snapshots that frames.csv lists.\n"
          << "set encoding utf8\nset datafile separator ','\n"
          << "stats 'frames.csv' using (column('t')) name 'all' nooutput\nn = int(all_records)\narray T[n]\narray N[n]\nk = 0\n"
          << "stats 'frames.csv' using (k = k + 1, T[k] = column('t'), N[k] = int(column('frame')), k) nooutput\n"
          << "# The range of every column over all frames.\n"
          << "lower(a, b) = a < b ? a : b\nupper(a, b) = a > b ? a : b\n"
          << "do for [i = 1:n] {\n    stats " << file("N[i]") << " using " << xy << " name 'f' nooutput\n"
          << "    if (i == 1) { x1 = f_min_x; x2 = f_max_x; y1 = f_min_y; y2 = f_max_y }\n"
          << "    x1 = lower(x1, f_min_x); x2 = upper(x2, f_max_x); y1 = lower(y1, f_min_y); y2 = upper(y2, f_max_y)\n";
        if (coloured)
            s << "    stats " << file("N[i]") << " using " << column(a.colour) << " name 'c' nooutput\n"
              << "    if (i == 1) { c1 = c_min; c2 = c_max }\n    c1 = lower(c1, c_min); c2 = upper(c2, c_max)\n";
        s << "}\nroom(a, b) = b > a ? 0.05 * (b - a) : abs(a) > 0 ? 0.05 * abs(a) : 1\n"
          << "set xrange [x1 - room(x1, x2) : x2 + room(x1, x2)]\nset yrange [y1 - room(y1, y2) : y2 + room(y1, y2)]\n"
          << "set terminal gif animate delay 8 loop 0 size 900,600 enhanced font 'DejaVuSans,14'\nset output " << in_gnuplot(name + ".gif")
          << "\n"
          << "set grid lc rgb '#dddddd' lt 1\nunset key\nset xlabel " << in_gnuplot(a.x_label) << "\nset ylabel " << in_gnuplot(a.y_label)
          << "\n";
        if (coloured)
            s << "set size ratio -1\nset cblabel " << in_gnuplot(a.colour_label)
              << "\nset cbrange [c1 : c2 > c1 ? c2 : c1 + room(c1, c2)]\n"
              << "set palette defined (0 '#30123b', 0.5 '#1f9e89', 1 '#fde725')\n";
        s << "do for [i = 1:n] {\n    set title " << in_gnuplot(title) << ".sprintf(\"\\nt = %.4g\", T[i]) noenhanced\n    plot "
          << file("N[i]") << " using " << xy
          << (coloured ? ":" + column(a.colour) + " with points pt 7 ps 0.8 lc palette"
                       : " with linespoints pt 7 ps 0.7 lw 2 lc rgb '#c03030'")
          << "\n}\nunset output\n";
    });
    return {list.path(), script};
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
