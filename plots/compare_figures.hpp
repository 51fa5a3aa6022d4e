/// The figures of a comparison: error against run time, error against h, histories over each other.
#pragma once
#include <string>
#include <vector>

#include "plots/stack.hpp"

namespace mpm {

struct Subject {
    std::string folder, error, scene, shared;  // of the sweep; the error looked at; the scene and the options that all have in common
    std::vector<Series> series;
    std::string title = {}, error_label = {};  // of the figures; empty: made of the scene, and of the error's name
    bool cpu = false;                          // the seconds of the series are CPU seconds
};

/// errors.csv (what the figures show) with work_precision.gp and convergence.gp. Returns the names of the figures to draw; none where no
/// run has an error.
std::vector<std::string> write_error_figures(const Subject& subject, std::vector<std::string>& files);

/// history_NAME.gp: that column of history.csv of each variant at `cells` (0: its finest), and the exact one. Throws BadInput where no run
/// has it.
std::string write_history_figure(const Subject& subject, const std::string& column, int cells, std::vector<std::string>& files);

}  // namespace mpm
