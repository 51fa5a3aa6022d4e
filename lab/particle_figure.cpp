#include <algorithm>
#include <cstdio>
#include <ostream>
#include <string_view>

#include "lab/figure.hpp"
#include "lab/gnuplot.hpp"
#include "lab/record.hpp"

namespace mpm {

using namespace detail;

namespace {

/// The snapshots as gnuplot's arrays T (time) and F (file), and n of them.
void arrays(std::ostream& s, const std::vector<Frame>& frames) {
    const std::string n = std::to_string(frames.size());
    s << "n = " << n << "\narray T[" << n << "] = [";
    for (std::size_t i = 0; i < frames.size(); ++i) s << (i > 0 ? ", " : "") << number_text(frames[i].t);
    s << "]\narray F[" << n << "] = [";
    for (std::size_t i = 0; i < frames.size(); ++i) s << (i > 0 ? ", " : "") << in_gnuplot(frames[i].file());
    s << "]\n";
}

/// Sets x1, x2, y1, y2 and, for colours, c1, c2 to the range of their columns over all snapshots.
void ranges(std::ostream& s, const Animated& a) {
    const bool coloured = !a.colour.empty();
    const std::string file = a.domains ? "'domains'.F[i][10:*]" : "F[i]";
    s << "# The range of every column over all snapshots.\n"
      << "lower(a, b) = a < b ? a : b\nupper(a, b) = a > b ? a : b\n"
      << "do for [i = 1:n] {\n    stats " << file << " using " << column(a.x) << ":" << column(a.y) << " name 'f' nooutput\n"
      << "    if (i == 1) { x1 = f_min_x; x2 = f_max_x; y1 = f_min_y; y2 = f_max_y }\n"
      << "    x1 = lower(x1, f_min_x); x2 = upper(x2, f_max_x); y1 = lower(y1, f_min_y); y2 = upper(y2, f_max_y)\n";
    if (coloured)
        s << "    stats F[i] using " << column(a.colour) << " name 'c' nooutput\n"
          << "    if (i == 1) { c1 = c_min; c2 = c_max }\n    c1 = lower(c1, c_min); c2 = upper(c2, c_max)\n";
    s << "}\nroom(a, b) = b > a ? 0.05 * (b - a) : abs(a) > 0 ? 0.05 * abs(a) : 1\n"
      << "dx = room(x1, x2); x1 = x1 - dx; x2 = x2 + dx\ndy = room(y1, y2); y1 = y1 - dy; y2 = y2 + dy\n";
}

/// The plot of snapshot i.
std::string particles(const Animated& a) {
    if (a.domains)
        return "splot 'domains'.F[i][10:*] using " + column(a.x) + ":" + column(a.y) + ":" + column(a.colour) + " with polygons fc palette\n";
    const std::string half = "(0.515 * sqrt(abs(column('V'))))";  // squares that fill the body's area and hide the seams
    return "plot F[i] using " + column(a.x) + ":" + column(a.y) + ":" + half + ":" + half + ":" + column(a.colour) +
           " with boxxyerror fs solid noborder lc palette\n";
}

/// Domains seen from above, their height the colour. A map's labels lie further out than those of a plane plot.
constexpr const char* polygon_style =
    "set view map\nset pm3d border lc rgb '#404040' lw 0.3\nset style fill solid border lc rgb '#404040'\n"
    "set xtics offset 0,0.6\nset xlabel offset 0,1\nset ylabel offset 0.3,0\nset cblabel offset 1.5,0\n";

/// Panels of equal axes in pixels: in a row or, where the particles lie far wider than high, one below the other.
constexpr const char* layout = R"(# Sizes in pixels: each panel, what is around all of them, what is between them.
aspect = (y2 - y1) / (x2 - x1)
wide = aspect < 0.4
pw = wide ? 820 : n < 3 ? 450 : 330
pw = lower(pw, 620 / aspect)
ph = pw * aspect
left = 110; right = 195; top = 85; bottom = 88
gap = wide ? 70 : 25
end = left + (wide ? pw : n * pw + (n - 1) * gap)
W = upper(1.0 * int(end + right), 1050)  # at least as wide as a title
H = 1.0 * int(top + bottom + (wide ? n * ph + (n - 1) * gap : ph))
# At most about four steps on an axis of length r.
power(r) = 10.0 ** floor(log10(r / 4))
step(r) = power(r) * (r / 4 / power(r) < 1.5 ? 1 : r / 4 / power(r) < 3.5 ? 2 : r / 4 / power(r) < 7.5 ? 5 : 10)
)";

constexpr const char* panels = R"(set xrange [x1 : x2]
set yrange [y1 : y2]
step_x = step(x2 - x1)
step_y = (wide ? 2 : 1) * step(y2 - y1)
set xtics step_x
set ytics step_y
set colorbox user origin (end + 20.0) / W, (bottom + (wide ? 0.5 * (H - top - bottom - lower(H - top - bottom, 500.0)) : 0.0)) / H \
    size 22.0 / W, lower(H - top - bottom, 500.0) / H
do for [i = 1:n] {
    column_i = wide ? 0 : i - 1
    row_i = wide ? i - 1 : 0
    set lmargin at screen (left + column_i * (pw + gap)) / W
    set rmargin at screen (left + column_i * (pw + gap) + pw) / W
    set tmargin at screen 1 - (top + row_i * (ph + gap)) / H
    set bmargin at screen 1 - (top + row_i * (ph + gap) + ph) / H
    set title sprintf('t = %.4g', T[i]) offset 0,-0.6
    if (column_i > 0) { set format y ''; unset ylabel }
    if (wide && i < n) { set format x ''; unset xlabel }
    if (wide && i == n) { set format x '%g'; set xlabel x_label offset 0,0.4 }
    if (i > 1) { unset colorbox }
)";

}  // namespace

std::string Frame::file() const {
    char name[48];
    std::snprintf(name, sizeof name, "particles_%04ld.csv", number);
    return name;
}

std::string column_label(const std::string& column) {
    constexpr std::string_view suffix = "_smooth";
    if (column.ends_with(suffix)) {
        const std::string text = column_label(column.substr(0, column.size() - suffix.size()));
        return text.substr(0, text.rfind(" [")) + ", smoothed" + text.substr(text.rfind(" ["));
    }
    static const std::vector<std::pair<std::string_view, const char*>> known{
        {"x", "x [length]"}, {"y", "y [length]"}, {"vx", "velocity v_x [length/time]"}, {"vy", "velocity v_y [length/time]"},
        {"speed", "speed |v| [length/time]"}, {"sxx", "stress σ_{xx} [force/area]"}, {"syy", "stress σ_{yy} [force/area]"},
        {"sxy", "stress σ_{xy} [force/area]"}, {"szz", "stress σ_{zz} [force/area]"}, {"pressure", "pressure [force/area]"},
        {"mises", "von Mises stress [force/area]"}, {"J", "volume ratio J [-]"}, {"V", "volume V [volume]"}, {"body", "body [-]"},
        {"T", "temperature T [temperature]"}};
    for (const auto& [name, text] : known)
        if (name == column) return text;
    std::string words = column;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::vector<std::string> write_animation(const std::string& folder, const std::string& name, const std::string& title, const Animated& a,
                                         const std::vector<Frame>& frames) {
    const bool coloured = !a.colour.empty();
    CsvFile list(folder + "/frames.csv", {"frame", "t", "file"});
    for (const Frame& frame : frames) list.row({std::to_string(frame.number), number_text(frame.t), frame.file()});
    const std::string script = write_script(folder, name, [&](std::ostream& s) {
        s << "# gnuplot " << name << ".gp draws " << name << ".gif from the snapshots.\n"
          << "tex = 0\nset encoding utf8\nset datafile separator ','\n";
        arrays(s, frames);
        ranges(s, a);
        s << "set xrange [x1 : x2]\nset yrange [y1 : y2]\n"
          << "set terminal gif animate delay 8 loop 0 size 900,700 enhanced font 'DejaVuSans,14'\nset output " << in_gnuplot(name + ".gif")
          << "\nset grid lc rgb '#dddddd' lt 1\nunset key\nset xlabel " << in_gnuplot(a.x_label) << "\nset ylabel " << in_gnuplot(a.y_label)
          << "\n";
        if (coloured) {
            s << "set size ratio -1\n";
            s << colour_scale(a.colour, a.colour_label);
        }
        if (a.domains) s << polygon_style;
        s << "do for [i = 1:n] {\n    set title " << in_gnuplot(title) << ".sprintf(\"\\nt = %.4g\", T[i]) noenhanced\n    "
          << (coloured ? particles(a)
                       : "plot F[i] using " + column(a.x) + ":" + column(a.y) + " with linespoints pt 7 ps 0.7 lw 2 lc rgb '#c03030'\n")
          << "}\nunset output\n";
    });
    return {list.path(), script};
}

std::string write_particle_figure(const std::string& folder, const std::string& name, const std::string& title, const Animated& a,
                                  const std::vector<Frame>& frames) {
    constexpr std::size_t most = 4;
    std::vector<Frame> shown;
    const std::size_t count = std::min(most, frames.size());
    for (std::size_t i = 0; i < count; ++i) shown.push_back(frames[count > 1 ? i * (frames.size() - 1) / (count - 1) : 0]);
    return write_script(folder, name, [&](std::ostream& s) {
        s << script_start(name);
        arrays(s, shown);
        ranges(s, a);
        s << layout << script_terminal(name, "W", "H") << "x_label = " << label(a.x_label)
          << "\nset xlabel x_label offset 0,0.4\nset ylabel " << label(a.y_label) << " offset 1.5,0\n"
          << "unset key\nset grid lc rgb '#dddddd' lt 1 lw 1\n";
        s << colour_scale(a.colour, a.colour_label);
        if (a.domains) s << polygon_style;
        s << "set multiplot title " << label(title, true) << " noenhanced\n" << panels << "    " << particles(a) << "}\nunset multiplot\n";
    });
}

}  // namespace mpm
