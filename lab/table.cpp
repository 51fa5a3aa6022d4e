#include "lab/table.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "lab/norms.hpp"
#include "lab/record.hpp"

namespace mpm {

const std::vector<std::string>& summary_columns() {
    static const std::vector<std::string> names{
        "program", "case", "scheme", "shape", "transfer", "options", "dim", "cells", "h", "ppc", "particles", "dt", "cfl", "steps",
        "t_end", "threads", "error_name", "error", "order", "reference", "energy_drift", "momentum_drift", "wall_s", "cpu_s",
        "ns_per_particle_step", "peak_rss_kb", "bytes_per_particle", "bytes_per_node", "verdict", "t_fail", "reason"};
    return names;
}

std::vector<std::string> summary_fields(const SummaryRow& r) {
    const auto n = [](double x) { return number_text(x); };
    const auto i = [](long x) { return std::to_string(x); };
    return {r.program, r.scene, r.scheme, r.shape, r.transfer, r.options, i(r.dim), i(r.cells), n(r.h), i(r.ppc), i(r.particles),
            n(r.dt), n(r.cfl), i(r.steps), n(r.t_end), i(r.threads), r.error_name, n(r.error), n(r.order), r.reference,
            n(r.energy_drift), n(r.momentum_drift), n(r.wall_s), n(r.cpu_s), n(r.ns_per_particle_step), i(r.peak_rss_kb),
            i(r.bytes_per_particle), i(r.bytes_per_node), r.verdict, n(r.t_fail), r.reason};
}

SummaryRow summary_row(const std::vector<std::string>& fields) {
    if (fields.size() != summary_columns().size()) throw std::invalid_argument("a summary row has " + std::to_string(summary_columns().size()) + " fields");
    SummaryRow r;
    auto next = fields.begin();
    const auto read = [&](auto& value) {
        const std::string& text = *next++;
        using T = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<T, std::string>) {
            value = text;
        } else {
            char* end = nullptr;
            if constexpr (std::is_same_v<T, double>) value = std::strtod(text.c_str(), &end);
            else value = static_cast<T>(std::strtol(text.c_str(), &end, 10));
            if (text.empty() || *end != '\0')
                throw std::invalid_argument("column " + summary_columns()[static_cast<std::size_t>(next - fields.begin()) - 1] + ": not a number: " + one_line(text));
        }
    };
    const auto all = [&](auto&... values) { (read(values), ...); };
    all(r.program, r.scene, r.scheme, r.shape, r.transfer, r.options, r.dim, r.cells, r.h, r.ppc, r.particles, r.dt, r.cfl, r.steps, r.t_end, r.threads,
        r.error_name, r.error, r.order, r.reference, r.energy_drift, r.momentum_drift, r.wall_s, r.cpu_s, r.ns_per_particle_step, r.peak_rss_kb,
        r.bytes_per_particle, r.bytes_per_node, r.verdict, r.t_fail, r.reason);
    return r;
}

void fill_orders(std::vector<SummaryRow>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].order = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t j = i; j-- > 0;) {
            if (rows[j].error_name != rows[i].error_name) continue;
            if (rows[j].verdict == "ok" && rows[i].verdict == "ok" && rows[j].h != rows[i].h)
                rows[i].order = observed_order(rows[j].error, rows[j].h, rows[i].error, rows[i].h);
            break;
        }
    }
}

std::string error_table(const std::vector<SummaryRow>& rows) {
    std::string text = "   cells          h      steps  error                      rate    seconds  energy gain  verdict\n";
    for (const SummaryRow& r : rows) {
        char line[256];
        std::snprintf(line, sizeof line, "%8d %10.4g %10ld  %-14s %10.3e %6.2f %10.3g %12.2e  %s\n", r.cells, r.h, r.steps,
                      r.error_name.c_str(), r.error, r.order, r.wall_s, r.energy_drift, r.verdict.c_str());
        text += line;
    }
    return text;
}

}  // namespace mpm
