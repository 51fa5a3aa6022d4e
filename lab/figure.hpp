/// gnuplot figures: a script beside its CSV, drawn offscreen on request. Data goes to CSV first; the script names the file.
/// Texts may hold _x and ^x for indices and powers, and Greek letters in UTF-8; the picture for LaTeX gets them as formulas.
#pragma once
#include <string>
#include <vector>

namespace mpm {

struct Curve {
    std::string y, title, style = "lines";  // column by name; without a style of its own it takes the figure's next colour and dash
};
struct Panel {
    std::string title, x, x_label, y_label;
    std::vector<Curve> curves;
    std::string x_range;         // "[a:b]" or ""
    std::string csv = {};        // where its columns are, if not in the figure's file
    std::string surface_y = {};  // then the one curve is a height over the columns x and surface_y
    int surface_rows = 0;        // of the square of points where the height is given
    std::string y_range = {};    // "[a:b]" or ""
};

/// Writes folder/name.gp, panels row by row from the CSV file `csv` beside it. `gnuplot name.gp` in that folder draws name.png; another
/// kind by `gnuplot -e "kind='svg'" name.gp`. Throws FileTrouble.
std::string write_figure(const std::string& folder, const std::string& name, const std::string& csv, const std::string& title,
                         const std::vector<Panel>& panels, int columns = 1);

/// A figure of its own kind: writes folder/name.gp with the gnuplot commands `body` behind what all figures share (terminal by `kind`, size
/// in pixels, commas, grid, line types), to be drawn as those of write_figure are. Throws FileTrouble.
std::string write_drawing(const std::string& folder, const std::string& name, int width, int height, const std::string& body);

/// What an animation shows of each snapshot's particles, by column name: y against x or, with a third column, particles in its colours,
/// each a square of its area V.
struct Animated {
    std::string x = "x", y = "v", colour = {};
    std::string x_label = "x [length]", y_label = "v [length/time]", colour_label = {};
    bool domains = false;  // particles have domains, which are drawn instead of squares
};
struct Frame {
    long number;
    double t;                  // [time]
    std::string file() const;  // particles_NNNN.csv
};

/// Writes folder/frames.csv (t and file of each snapshot) and folder/name.gp, which draws name.gif from them with axes that stay.
/// Returns the paths of both. Throws FileTrouble.
std::vector<std::string> write_animation(const std::string& folder, const std::string& name, const std::string& title,
                                         const Animated& animated, const std::vector<Frame>& frames);

/// Writes folder/name.gp, a row of up to four of the snapshots, the first and the last among them (a column of them if the particles lie
/// far wider than high), with one scale of colours. Returns its path. Throws FileTrouble.
std::string write_particle_figure(const std::string& folder, const std::string& name, const std::string& title, const Animated& animated,
                                  const std::vector<Frame>& frames);

/// What a snapshot's column is, with its unit, for a scale of colours.
std::string column_label(const std::string& column);

/// Draws folder/name.gp as png, svg, pdf or tikz, or an animation as gif. Returns the picture's path, or "" when gnuplot is missing or
/// fails (and says why in `why`).
std::string draw_figure(const std::string& folder, const std::string& name, const std::string& kind, std::string& why);

/// draw_figure for programs: adds the picture to `files`, or says on stderr why there is none. Kind "none" does nothing.
void add_picture(const std::string& folder, const std::string& name, const std::string& kind, std::vector<std::string>& files);

}  // namespace mpm
