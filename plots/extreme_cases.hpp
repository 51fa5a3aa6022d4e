/// What became of each cell of a table of extreme cases.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "plots/case_table.hpp"
#include "plots/stability_cases.hpp"
#include "plots/sweep.hpp"

namespace mpm {

/// One cell. `kind` is
///   error       the run ended well, within the bound: `error`
///   limit       the largest stable step: `error`
///   unstable    it ended as a named instability, or did so at a step beyond the limit
///   none        not offered: `reason`
///   inaccurate  the run ended well, but the error is over the bound; or beyond the limit nothing was noticed; `known`: why
///   failed      no result
struct Cell {
    std::string kind = "none", error_name, verdict, reason;
    double error, bound, seconds;
    std::string known = {};
    bool defect() const { return kind == "failed" || (kind == "inaccurate" && known.empty()); }
    std::string shown() const;  // "1.9e-4", "fracture", "-"
};

/// Runs the cells of one table, several at a time; steps and limits one after the other. What has ended is not run again.
class ExtremeRuns {
public:
    ExtremeRuns(Programs& programs, const CaseTable& table, const std::string& folder, const RunRules& rules, bool quick);

    const std::vector<ExtremeCase>& cases() const { return cases_; }
    /// [case][column]; nothing when interrupted.
    std::optional<std::vector<std::vector<Cell>>> all();

private:
    Run run_of(const Words& command, const std::string& name, std::string& why_not) const;
    std::optional<Found> found(const Run& run, const std::string& error, double& seconds) const;
    std::optional<Cell> limit(const ExtremeCase& row, const CaseColumn& column, double& step) const;
    std::optional<Cell> at_step(const ExtremeCase& row, const CaseColumn& column) const;

    Programs& programs_;
    const CaseTable& table_;
    std::string folder_;
    RunRules rules_;
    std::vector<ExtremeCase> cases_;
};

}  // namespace mpm
