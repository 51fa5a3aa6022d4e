/// gnuplot figures: a script beside its CSV, drawn offscreen on request. Data goes to CSV first; the script names the file.
#pragma once
#include <string>
#include <vector>

namespace mpm {

struct Curve {
    std::string y, title, style = "lines";  // column by name
};
struct Panel {
    std::string title, x, x_label, y_label;
    std::vector<Curve> curves;
    std::string x_range;  // "[a:b]" or ""
};

/// Writes folder/name.gp, panels one under the other from the CSV file `csv` beside it. `gnuplot name.gp` in that folder draws name.png; another
/// kind by `gnuplot -e "kind='svg'" name.gp`. Throws FileTrouble.
std::string write_figure(const std::string& folder, const std::string& name, const std::string& csv, const std::string& title,
                         const std::vector<Panel>& panels);

/// Draws folder/name.gp as png, svg, pdf or tikz. Returns the picture's path, or "" when gnuplot is missing or fails (and says why in `why`).
std::string draw_figure(const std::string& folder, const std::string& name, const std::string& kind, std::string& why);

}  // namespace mpm
