/// basis_functions: the weighting functions of review 3.2 to 3.5 as tables and figures (review figures 11, 17, 18, 20 to 22), and their checks.
///   ./basis_functions --shape cubic --cells 5 --plot png
#include <cstdio>

#include "chapters/weighting/sampled.hpp"
#include "chapters/weighting/shapes.hpp"
#include "lab/program.hpp"

using namespace mpm;

namespace {

constexpr const char* program = "basis_functions";
constexpr const char* purpose = "weighting functions and their gradients on a small grid";

struct Settings {
    int cells = 4, points = 40;
    double l = 0.5, F = 1.5;
    std::string shape = "all", out, label, plot = "none";
    bool quiet = false;
    int coarse() const { return std::min(points, 10); }  // a surface of more samples prints no better
};

/// A header row and the columns below it.
void write_columns(const std::string& path, const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns) {
    CsvFile file(path, names);
    std::vector<double> row(columns.size());
    for (std::size_t i = 0; i < columns.front().size(); ++i) {
        for (std::size_t c = 0; c < columns.size(); ++c) row[c] = columns[c][i];
        file.row(row.data(), row.size());
    }
}

std::vector<Sampled> sample_all(const Settings& set) {
    std::vector<Sampled> all;
    for (const std::string& name : AllShapes::names()) {
        if (set.shape != "all" && set.shape != name) continue;
        AllShapes::with(name, [&](auto kernel) {
            if (set.cells < kernel.min_cells)
                throw BadInput("--cells = " + std::to_string(set.cells) + ": allowed for " + name + " >= " + std::to_string(kernel.min_cells));
            if constexpr (requires { kernel.l; }) kernel.l = set.l;
            if constexpr (requires { kernel.l0; }) {
                kernel.l0 = set.l;
                if (set.l * set.F > 2) throw BadInput("--F = " + number_text(set.F) + ": allowed with --l " + number_text(set.l) + " up to " + number_text(2 / set.l));
            }
            all.push_back(sample(kernel, set.F, set.cells, set.points, set.coarse()));
        });
    }
    return all;
}

std::string title_of(const Sampled& s, const Settings& set) {
    if (s.name == "ugimp") return "ugimp, l_p = " + number_text(set.l) + " h";
    return s.name == "cpgimp" ? "cpgimp, l_p = " + number_text(set.l * set.F) + " h" : s.name;
}

void write_tables(const std::string& folder, const std::vector<Sampled>& all, const Settings& set) {
    std::vector<std::string> names{"x"}, names_2d{"x", "y"};
    std::vector<std::vector<double>> phi{line_places(set.cells, set.points)}, grad = phi, square(2);
    for (const Vec<2>& x : square_places(set.cells * set.coarse() + 1, 1.0 / set.coarse())) square[0].push_back(x[0]), square[1].push_back(x[1]);
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

void write_figures(const std::string& folder, const std::vector<Sampled>& all, const Settings& set) {
    std::vector<Panel> lines, surfaces;
    for (const Sampled& s : all) {
        std::vector<Curve> nodes;
        for (std::size_t I = 0; I < s.phi.size(); ++I) nodes.push_back({s.name + "_" + std::to_string(I), (s.phi.size() > 13 ? "" : "φ_" + std::to_string(I))});
        lines.push_back({title_of(s, set), "x", "x / h", "φ_I", nodes, ""});
        lines.push_back({title_of(s, set), "x", "x / h", "h dφ_I/dx", nodes, "", "gradients_1d.csv"});
        const int rows = set.cells * set.coarse() + 1;
        surfaces.push_back({title_of(s, set) + ": φ_I", "x", "x / h", "y / h", {{s.name, ""}}, "", "", "y", rows});
        surfaces.push_back({title_of(s, set) + ": h ∂φ_I/∂x", "x", "x / h", "y / h", {{s.name + "_dx", ""}}, "", "", "y", rows});
    }
    const std::string on = " on a grid of " + std::to_string(set.cells) + " cells";
    write_figure(folder, program, "basis_1d.csv", "Weighting functions and their gradients" + on, lines, 2);
    write_figure(folder, "basis_2d", "basis_2d.csv", "The middle node's weighting function and gradient" + on + " a side", surfaces, 2);
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Settings set;
    std::vector<std::string> shapes = AllShapes::names();
    shapes.push_back("all");
    options.choice("shape", set.shape, shapes, "weighting function");
    options.integer("cells", set.cells, "cells", between(1, 10), "cells of the grid along each axis");
    options.integer("points", set.points, "-", between(1, 1000), "samples per cell; surfaces have at most 10");
    options.number("l", set.l, "cells", {.low = 0, .high = 1, .low_open = true}, "initial size of a particle (ugimp, cpgimp)");
    options.number("F", set.F, "-", above(0), "stretch of the particle (cpgimp)");
    options.text("out", set.out, "folder of the run; empty: out/<program>/<label>");
    options.text("label", set.label, "name of the run; empty: made of the options that differ");
    options.choice("plot", set.plot, {"none", "png", "svg", "pdf", "tikz"}, "picture to draw");
    options.flag("quiet", set.quiet, "say nothing but errors");
    for (const char* name : {"out", "label", "plot", "quiet"}) options.unlabelled(name);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;

    const std::string folder = run_folder(program, options, set.out, set.label);
    const std::vector<Sampled> all = sample_all(set);
    make_folder(folder);
    write_file(folder + "/run.ini", options.ini());
    write_tables(folder, all, set);
    write_figures(folder, all, set);
    std::vector<std::string> files;
    for (const char* name : {"run.ini", "basis_1d.csv", "gradients_1d.csv", "basis_2d.csv", "checks.csv", "basis_functions.gp", "basis_2d.gp"})
        files.push_back(folder + "/" + name);
    for (const char* name : {program, "basis_2d"}) add_picture(folder, name, set.plot, files);
    if (set.quiet) return 0;
    std::printf("%s: %s, %d cells, in one and two dimensions\n", program, purpose, set.cells);
    std::printf("%-10s %5s  %21s  %20s  %28s  %15s\n", "shape", "nodes", "|sum of weights - 1|", "|sum of gradients|", "|gradient - difference| h", "smallest weight");
    for (const auto& [name, phi, grad, surface, surface_dx, d] : all)
        std::printf("%-10s %5zu  %21.1e  %20.1e  %28.1e  %15.1e\n", name.c_str(), phi.size(), d.unity, d.gradients, d.difference, d.smallest);
    std::printf("written:");
    for (const std::string& file : files) std::printf(" %s", file.c_str());
    std::printf("\n");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
