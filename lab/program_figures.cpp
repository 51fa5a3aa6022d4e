#include "lab/program_figures.hpp"

#include <algorithm>

namespace mpm {
namespace {

/// What the scene watches, where it says no more of it: one panel.
Panel own_panel(const Description& about, const std::string& range) {
    std::vector<Curve> own;
    std::string label;
    for (const std::string& name : about.columns) {
        const bool exact = name.ends_with("_exact");
        own.push_back({name, exact ? "exact" : about.columns.size() > 2 ? name : "computed",
                       exact ? "lines dt 2 lc rgb 'black'" : "lines dt solid lc rgb '#c03030'"});
        if (!exact) label.append(label.empty() ? "" : ", ").append(name == "v_cm" ? "v_{cm} [length/time]" : name);
    }
    return {"", "t", "time t [time]", label, own, range};
}

/// Both components on an axis that shows a tenth of the momentum in play, so that rounding is a line.
Panel momentum_panel(double in_play, const std::string& range) {
    const std::string low = number_text(-0.1 * in_play), high = number_text(0.1 * in_play);
    Panel panel{"", "t", "time t [time]", "momentum [force time]",
                {{"momentum_x", "x", "lines dt solid lc rgb '#c03030'"}, {"momentum_y", "y", "lines dt (8,3) lc rgb '#3060c0'"}}, range};
    if (in_play > 0) panel.y_range = "[* < " + low + " : " + high + " < *]";
    return panel;
}

}  // namespace

void history_figure(const Description& about, const Common& c, const Assembled& a, const RunResult& r, const std::string& folder,
                    std::vector<std::string>& files) {
    const double window = about.period > 0 ? std::min(c.t_end, 10 * about.period) : c.t_end;
    const std::string first = "[0:" + number_text(window) + "]";
    std::vector<Panel> panels = about.panels;
    if (panels.empty()) panels.push_back(own_panel(about, first));
    if (about.moves)
        panels.push_back({"",
                      "t",
                      "time t [time]",
                      "energy [force length]",
                      {{"kinetic", "kinetic", "lines dt (8,3) lc rgb '#3060c0'"},
                       {"strain", "strain", "lines dt (2,3) lc rgb '#40a040'"},
                       {"total", "total", "lines dt solid lc rgb 'black'"}},
                      first});
    if (about.moves && a.row.dim == 2) panels.push_back(momentum_panel(r.momentum_in_play, first));
    files.push_back(write_figure(folder, about.program, "history.csv", about.program + ": " + about.solves, panels));
    if (c.plot != "gif") add_picture(folder, about.program, c.plot, files);
}

bool shows_particles(const Common& c, const Assembled& a) { return c.plot == "gif" || (c.plot != "none" && a.row.dim == 2); }

void particle_figures(const Description& about, const Common& c, const Assembled& a, const RunResult& r, const std::string& folder,
                      std::vector<std::string>& files) {
    if (r.frames.empty() || (c.format != "csv" && !shows_particles(c, a))) return;
    const std::string name = about.program + "_animation", still = about.program + "_particles";
    const std::string title = about.program + ": " + about.solves;
    for (const std::string& path : write_animation(folder, name, title, a.animated, r.frames)) files.push_back(path);
    if (c.plot == "gif") add_picture(folder, name, c.plot, files);
    if (a.row.dim != 2) return;
    files.push_back(write_particle_figure(folder, still, title, a.animated, r.frames));
    if (c.plot != "gif") add_picture(folder, still, c.plot, files);
}

}  // namespace mpm
