/// What cell_crossing writes: the runs' histories side by side with one column for each weighting function, summary rows, and the figure.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "chapters/scenes/two_bodies.hpp"
#include "lab/csv_read.hpp"
#include "lab/program.hpp"
#include "lab/study.hpp"

namespace mpm::crossing {

struct Settings : Study {
    TwoBodies scene;
    int ppc = 1, records = 4000;
    double cfl = 0.015, dt = 0;
    std::string shape = "all", watch = "stop";
};

/// One weighting function's run.
struct Run {
    SummaryRow row;
    std::vector<NamedError> errors;
    RunResult result;
    int crossings = 0;
};

/// Whole steps, as every program takes them. Throws BadInput.
inline RunPlan plan_of(const Settings& set, const Assembled& a, const std::string& folder) {
    RunPlan plan = whole_steps(set.scene.t_end, set.dt > 0 ? set.dt : set.cfl * a.critical_dt, a.critical_dt);
    plan.records = set.records;
    plan.stop_on_trouble = set.watch == "stop";
    plan.folder = folder;
    plan.columns.assign(TwoBodies::columns.begin(), TwoBodies::columns.end());
    return plan;
}

/// Fills in what the run has shown; errors of a run that stopped early are nan.
inline void finish(Run& run, const RunPlan& plan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    add_result(run.row, plan, run.result);
    run.row.order = nan;
    for (NamedError& e : run.errors)
        if (run.result.stopped) e.value = nan;
}

inline void write_summary(const std::string& path, const std::vector<Run>& runs) {
    CsvFile file(path, summary_columns());
    for (const Run& run : runs)
        for (const NamedError& e : run.errors) {
            SummaryRow row = run.row;
            row.error_name = e.name;
            row.error = e.value;
            file.row(summary_fields(row));
        }
}

/// The folder of a shape's own history: of several, each has one.
inline std::string folder_of(const std::string& folder, const std::string& shape, const Settings& set) {
    return set.shape == "all" ? folder + "/" + shape : folder;
}

/// All steps are of one length, so that rows belong to the same times; a history that ends early ends in nan.
inline void write_together(const std::string& folder, const std::vector<std::string>& shapes, const Settings& set) {
    const std::vector<std::string> own{"x", "v", "stress", "strain_rate", "kinetic", "strain"};
    std::vector<CsvTable> histories;
    std::vector<std::string> names{"t"};
    std::size_t longest = 0;
    for (const std::string& shape : shapes) {
        histories.push_back(read_csv(folder_of(folder, shape, set) + "/history.csv"));
        if (histories.back().rows.size() > histories[longest].rows.size()) longest = histories.size() - 1;
        for (const std::string& name : own) names.push_back(name + "_" + shape);
    }
    CsvFile file(folder + "/cell_crossing.csv", names);
    for (std::size_t i = 0; i < histories[longest].rows.size(); ++i) {
        std::vector<std::string> row{histories[longest].text(i, "t")};
        for (const CsvTable& history : histories)
            for (const std::string& name : own) row.push_back(i < history.rows.size() ? history.text(i, name) : "nan");
        file.row(row);
    }
}

inline void write_figures(const std::string& folder, const std::vector<std::string>& shapes, const Settings& set) {
    const auto panel = [&](const std::string& column, const std::string& label) {
        std::vector<Curve> curves;
        for (const std::string& shape : shapes) curves.push_back({column + "_" + shape, shape});
        return Panel{"", "t", "time t [time]", label, curves, ""};
    };
    const std::string ppc = std::to_string(set.ppc) + (set.ppc > 1 ? " particles" : " particle");
    write_figure(folder, "cell_crossing", "cell_crossing.csv",
                 "Two bodies of " + ppc + " meet: the inner particle of the first, and the strain energy",
                 {panel("x", "position x [length]"), panel("stress", "stress σ [stress]"), panel("strain_rate", "strain rate L [1/time]"),
                  panel("strain", "strain energy U [energy]")},
                 2);
}

}  // namespace mpm::crossing
