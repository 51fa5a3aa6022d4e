/// The figures of `stability`: bars for the largest stable steps, a map of variants against stiff cases.
#pragma once
#include <string>
#include <vector>

#include "lab/run.hpp"
#include "plots/stability_cases.hpp"

namespace mpm {

/// One variant with all that was found of it.
struct Probed {
    std::string name;
    Limit limit;
    std::vector<Found> found;  // one for each case
    std::string unit = wave_limit;  // its critical step
};
/// "1.98 (then energy-growth)": the largest stable fraction and how it fails beyond.
std::string limit_text(const Limit& limit);

/// stability_steps.csv with stability_steps.gp. Returns the name of the figure.
std::string write_step_figure(const std::string& folder, const std::string& title, const std::vector<Probed>& probed,
                              std::vector<std::string>& files);
/// stability_map.csv with stability_map.gp. Columns in which nothing was run are left out; returns "" if none is left.
std::string write_case_map(const std::string& folder, const std::string& title, const std::vector<Case>& cases,
                           const std::vector<Probed>& probed, std::vector<std::string>& files);

}  // namespace mpm
