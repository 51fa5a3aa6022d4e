/// basis_functions: the weighting functions of review 3.2 to 3.5 as tables and figures (review figures 11, 17, 18, 20 to 22), and their
/// checks.
///   ./basis_functions --shape cubic --cells 5 --plot png
#include <cstdio>

#include "chapters/weighting/basis_tables.hpp"
#include "chapters/weighting/shapes.hpp"
#include "lab/program.hpp"

using namespace mpm;
using basis::Settings;

namespace {

constexpr const char* program = "basis_functions";
constexpr const char* purpose = "weighting functions and their gradients on a small grid";

std::vector<Sampled> sample_all(const Settings& set) {
    std::vector<Sampled> all;
    for (const std::string& name : AllShapes::names()) {
        if (set.shape != "all" && set.shape != name) continue;
        AllShapes::with(name, [&](auto kernel) {
            if (set.cells < kernel.min_cells)
                throw BadInput("--cells = " + std::to_string(set.cells) + ": allowed for " + name +
                               " >= " + std::to_string(kernel.min_cells));
            if constexpr (requires { kernel.l; }) kernel.l = set.l;
            if constexpr (requires { kernel.l0; }) {
                kernel.l0 = set.l;
                if (set.l * set.F > 2)
                    throw BadInput("--F = " + number_text(set.F) + ": allowed with --l " + number_text(set.l) + " up to " +
                                   number_text(2 / set.l));
            }
            all.push_back(sample(kernel, set.F, set.cells, set.points, set.coarse()));
        });
    }
    return all;
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Settings set;
    std::vector<std::string> shapes = AllShapes::names();
    shapes.push_back("all");
    options.choice("shape", set.shape, shapes, "weighting function");
    options.integer("cells", set.cells, "cells", between(1, 10), "cells of the grid along each axis");
    options.integer("points", set.points, "-", between(1, 1000), "samples per cell; surfaces have at most 10, and 40 along a side");
    options.number("l", set.l, "cells", {.low = 0, .high = 1, .low_open = true}, "initial size of a particle (ugimp, cpgimp)");
    options.number("F", set.F, "-", above(0), "stretch of the particle (cpgimp)");
    set.declare(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;

    const std::string folder = run_folder(program, options, set.out, set.label);
    const std::vector<Sampled> all = sample_all(set);
    make_folder(folder);
    write_file(folder + "/run.ini", options.ini());
    basis::write_tables(folder, all, set);
    basis::write_figures(folder, all, set);
    std::vector<std::string> files;
    for (const char* name :
         {"run.ini", "basis_1d.csv", "gradients_1d.csv", "basis_2d.csv", "checks.csv", "basis_functions.gp", "basis_2d.gp"})
        files.push_back(folder + "/" + name);
    for (const char* name : {program, "basis_2d"}) add_picture(folder, name, set.plot, files);
    if (set.quiet) return 0;
    std::printf("%s: %s, %d cells, in one and two dimensions\n", program, purpose, set.cells);
    std::printf("%-10s %5s  %21s  %20s  %28s  %15s\n", "shape", "nodes", "|sum of weights - 1|", "|sum of gradients|",
                "|gradient - difference| h", "smallest weight");
    for (const auto& [name, phi, grad, surface, surface_dx, d] : all)
        std::printf("%-10s %5zu  %21.1e  %20.1e  %28.1e  %15.1e\n", name.c_str(), phi.size(), d.unity, d.gradients, d.difference,
                    d.smallest);
    say_written(files);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
