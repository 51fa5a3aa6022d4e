/// What basis_functions writes: tables with one column for each function, and the scripts of their figures.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "chapters/weighting/sampled.hpp"
#include "lab/figure.hpp"
#include "lab/record.hpp"
#include "lab/study.hpp"

namespace mpm::basis {

struct Settings : Study {
    int cells = 4, points = 40;
    double l = 0.5, F = 1.5;
    std::string shape = "all";
    int coarse() const { return std::min({points, 10, 40 / cells}); }  // a surface of more samples prints no better
};

/// A header row and the columns below it.
inline void write_columns(const std::string& path, const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns) {
    CsvFile file(path, names);
    std::vector<double> row(columns.size());
    for (std::size_t i = 0; i < columns.front().size(); ++i) {
        for (std::size_t c = 0; c < columns.size(); ++c) row[c] = columns[c][i];
        file.row(row.data(), row.size());
    }
}

inline std::string title_of(const Sampled& s, const Settings& set) {
    if (s.name == "ugimp") return "ugimp, l_p = " + number_text(set.l) + " h";
    return s.name == "cpgimp" ? "cpgimp, l_p = " + number_text(set.l * set.F) + " h" : s.name;
}

inline void write_tables(const std::string& folder, const std::vector<Sampled>& all, const Settings& set) {
    std::vector<std::string> names{"x"}, names_2d{"x", "y"};
    std::vector<std::vector<double>> phi{line_places(set.cells, set.points)}, grad = phi, square(2);
    for (const Vec<2>& x : square_places(set.cells * set.coarse() + 1, 1.0 / set.coarse()))
        square[0].push_back(x[0]), square[1].push_back(x[1]);
    for (const Sampled& s : all) {
        for (std::size_t I = 0; I < s.phi.size(); ++I) names.push_back(s.name + "_" + std::to_string(I));
        phi.insert(phi.end(), s.phi.begin(), s.phi.end());
        grad.insert(grad.end(), s.grad.begin(), s.grad.end());
        names_2d.insert(names_2d.end(), {s.name, s.name + "_dx"});
        square.insert(square.end(), {s.surface, s.surface_dx});
    }
    write_columns(folder + "/basis_1d.csv", names, phi);
    write_columns(folder + "/gradients_1d.csv", names, grad);
    write_columns(folder + "/basis_2d.csv", names_2d, square);
    CsvFile checks(folder + "/checks.csv", {"shape", "nodes", "unity", "gradients", "difference", "smallest"});
    for (const Sampled& s : all)
        checks.row({s.name, std::to_string(s.phi.size()), number_text(s.deviations.unity), number_text(s.deviations.gradients),
                    number_text(s.deviations.difference), number_text(s.deviations.smallest)});
}

inline void write_figures(const std::string& folder, const std::vector<Sampled>& all, const Settings& set) {
    std::vector<Panel> lines, surfaces;
    for (const Sampled& s : all) {
        std::vector<Curve> nodes;
        for (std::size_t I = 0; I < s.phi.size(); ++I)
            nodes.push_back({s.name + "_" + std::to_string(I), (s.phi.size() > 13 ? "" : "φ_" + std::to_string(I))});
        lines.push_back({title_of(s, set), "x", "x / h", "φ_I", nodes, ""});
        lines.push_back({title_of(s, set), "x", "x / h", "h dφ_I/dx", nodes, "", "gradients_1d.csv"});
        const int rows = set.cells * set.coarse() + 1;
        surfaces.push_back({title_of(s, set) + ": φ_I", "x", "x / h", "y / h", {{s.name, ""}}, "", "", "y", rows});
        surfaces.push_back({title_of(s, set) + ": h ∂φ_I/∂x", "x", "x / h", "y / h", {{s.name + "_dx", ""}}, "", "", "y", rows});
    }
    const std::string on = " on a grid of " + std::to_string(set.cells) + " cells";
    write_figure(folder, "basis_functions", "basis_1d.csv", "Weighting functions and their gradients" + on, lines, 2);
    write_figure(folder, "basis_2d", "basis_2d.csv", "The middle node's weighting function and gradient" + on + " a side", surfaces, 2);
}

}  // namespace mpm::basis
