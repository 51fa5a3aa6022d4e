/// The summary row of one resolution, the same for every program, and the table of error against run time.
#pragma once
#include <string>
#include <vector>

namespace mpm {

struct SummaryRow {
    std::string program, scene, scheme, shape, transfer, options;
    int dim = 1, cells = 0;
    double h = 0;
    int ppc = 0;
    long particles = 0;
    double dt = 0, cfl = 0;
    long steps = 0;
    double t_end = 0;
    int threads = 1;
    std::string error_name;
    double error = 0, order = 0;
    std::string reference;
    double energy_drift = 0, momentum_drift = 0, wall_s = 0, cpu_s = 0, ns_per_particle_step = 0;
    long peak_rss_kb = 0;
    long bytes_per_particle = 0, bytes_per_node = 0;
    std::string verdict = "ok";
    double t_fail = 0;
    std::string reason;
};

/// The fixed header of summary.csv.
const std::vector<std::string>& summary_columns();
std::vector<std::string> summary_fields(const SummaryRow& row);
/// The inverse of summary_fields. Throws std::invalid_argument where a number is not one.
SummaryRow summary_row(const std::vector<std::string>& fields);

/// Fills `order` of every row against the row before with the same error name; nan where a run did not end well.
void fill_orders(std::vector<SummaryRow>& rows);

/// Cells, h, steps, error, rate, seconds, energy gain, verdict: a table for the screen.
std::string error_table(const std::vector<SummaryRow>& rows);

}  // namespace mpm
