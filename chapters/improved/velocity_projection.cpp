/// velocity_projection: particles of a linear velocity field give it to the grid and take it back (review 5.5.1, figure 55), with every
/// weighting function and every transfer: which of them keep the field, in the middle of the body and at its ends.
///   ./velocity_projection --cells 3 --ppc 1 --shape hat
#include "chapters/improved/velocity_projection.hpp"

#include <cstdio>
#include <utility>

#include "chapters/improved/affine.hpp"
#include "chapters/improved/consistent.hpp"
#include "chapters/improved/fmpm.hpp"
#include "lab/figure.hpp"
#include "lab/program.hpp"
#include "lab/record.hpp"

using namespace mpm;
using projection::Projected;
using projection::Settings;

namespace {

constexpr const char* program = "velocity_projection";
constexpr const char* purpose = "a linear velocity field from particles to the grid and back";
const std::vector<std::string> transfers{"flip", "apic", "fmpm", "consistent", "mls"};

/// All of them take particle velocities from the grid: the mix of FLIP and PIC is PIC.
template <class Kernel>
Projected project(const Settings& set, const std::string& transfer) {
    if (transfer == "apic") return projection::project<Kernel>(set, Apic<false>{});
    if (transfer == "fmpm") return projection::project<Kernel>(set, Fmpm{set.order});
    if (transfer == "mls") return projection::project<Kernel>(set, projection::Mls{{0}});
    if (transfer == "flip") return projection::project<Kernel>(set, Flip{0});
    Consistent<false> consistent;
    consistent.alpha = 0;
    return projection::project<Kernel>(set, consistent);
}

std::vector<Projected> project_all(const Settings& set) {
    std::vector<Projected> all;
    for (const std::string& shape : AllShapes::names()) {
        if (set.shape != "all" && set.shape != shape) continue;
        AllShapes::with(shape, [&](auto kernel) {
            using Kernel = decltype(kernel);
            if (set.cells + 2 * set.pad < Kernel::min_cells)
                throw BadInput("--cells = " + std::to_string(set.cells) + ": allowed for " + shape +
                               " >= " + std::to_string(Kernel::min_cells));
            for (const std::string& transfer : transfers)
                if (set.transfer == "all" || set.transfer == transfer) all.push_back(project<Kernel>(set, transfer));
        });
    }
    return all;
}

void declare(Options& o, Settings& set) {
    std::vector<std::string> shapes = AllShapes::names(), names = transfers;
    shapes.push_back("all");
    names.push_back("all");
    o.choice("shape", set.shape, shapes, "weighting function");
    o.choice("transfer", set.transfer, names, "how velocities go to the grid; flip: lumped mass");
    o.integer("order", set.order, "-", between(1, 1000), "terms of the series (fmpm)");
    o.number("length", set.length, "length", above(0), "length of the body");
    o.integer("cells", set.cells, "cells", between(3, 10000), "cells of the body");
    o.integer("pad", set.pad, "cells", between(0, 100), "cells of the grid beyond each end of the body");
    o.integer("ppc", set.ppc, "-", between(1, 100), "particles per cell");
    o.number("offset", set.offset, "cells", between(-0.5, 0.5), "shift of all particles within their cells");
    o.number("jitter", set.jitter, "-", between(0, 1), "random shifts of the particles, as part of their spacing");
    set.declare(o);
}

/// The rows of `all` that belong to one shape stand together.
using Group = std::pair<const Projected*, const Projected*>;
std::vector<Group> groups(const std::vector<Projected>& all) {
    std::vector<Group> result;
    for (const Projected& p : all) {
        if (result.empty() || result.back().first->shape != p.shape) result.push_back({&p, &p});
        ++result.back().second;
    }
    return result;
}

/// One file: the field beside what each transfer made of it, and its error in h.
void write_columns(const std::string& path, const Group& group, double h, std::vector<double> Projected::*x,
                   std::vector<double> Projected::*v) {
    std::vector<std::string> names{"x", "v_exact"};
    for (const Projected* p = group.first; p != group.second; ++p) names.insert(names.end(), {"v_" + p->transfer, "error_" + p->transfer});
    CsvFile file(path, names);
    for (std::size_t i = 0; i < (group.first->*x).size(); ++i) {
        const double exact = projection::field((group.first->*x)[i]);
        std::vector<double> row{(group.first->*x)[i], exact};
        for (const Projected* p = group.first; p != group.second; ++p) row.insert(row.end(), {(p->*v)[i], ((p->*v)[i] - exact) / h});
        file.row(row.data(), row.size());
    }
}

std::vector<std::string> write_files(const std::string& folder, const std::vector<Projected>& all, const Settings& set,
                                     const Options& options) {
    std::vector<std::string> files{folder + "/run.ini", folder + "/projection.csv"};
    write_file(files[0], options.ini());
    CsvFile table(files[1], {"shape", "transfer", "node_middle", "node_ends", "particle_middle", "particle_ends", "verdict"});
    for (const Projected& p : all)
        table.row({p.shape, p.transfer, number_text(p.nodes.middle), number_text(p.nodes.ends), number_text(p.particles.middle),
                   number_text(p.particles.ends), p.verdict});
    std::vector<Panel> panels;
    for (const Group& group : groups(all)) {
        const std::string &shape = group.first->shape, nodes = "nodes_" + shape + ".csv";
        files.push_back(folder + "/" + nodes);
        write_columns(files.back(), group, set.h(), &Projected::node_x, &Projected::node_v);
        files.push_back(folder + "/particles_" + shape + ".csv");
        write_columns(files.back(), group, set.h(), &Projected::particle_x, &Projected::particle_v);
        std::vector<Curve> curves;
        for (const Projected* p = group.first; p != group.second; ++p)
            curves.push_back({"error_" + p->transfer, p->transfer, "linespoints"});
        panels.push_back({shape, "x", "x [length]", "(v_I - v(x_I)) / h [1/time]", curves, "", nodes});
    }
    files.push_back(write_figure(folder, program, panels.front().csv, "Error of the nodal velocities of a linear velocity field", panels,
                                 panels.size() > 1 ? 2 : 1));
    return files;
}

void report(const std::vector<Projected>& all, const Settings& set, const std::vector<std::string>& files) {
    std::printf("%s: %s\n%d cells, h = %.4g, %zu particles; largest errors over h: 1 is the difference between neighbouring nodes\n",
                program, purpose, set.cells, set.h(), all.front().particle_x.size());
    std::printf("                       at nodes                    at particles, back from the grid\n");
    std::printf("shape      transfer    middle half  near the ends  middle half  near the ends\n");
    for (const Projected& p : all)
        std::printf("%-10s %-10s  %11.2e  %13.2e  %11.2e  %13.2e  %s\n", p.shape.c_str(), p.transfer.c_str(), p.nodes.middle, p.nodes.ends,
                    p.particles.middle, p.particles.ends, p.verdict == "ok" ? "" : p.verdict.c_str());
    say_written(files);
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Settings set;
    declare(options, set);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (set.order != 2 && set.transfer != "all" && set.transfer != "fmpm")
        throw BadInput("--order: only --transfer fmpm has terms of a series, not " + set.transfer);
    const std::string folder = run_folder(program, options, set.out, set.label);
    const std::vector<Projected> all = project_all(set);
    make_folder(folder);
    std::vector<std::string> files = write_files(folder, all, set, options);
    add_picture(folder, program, set.plot, files);
    if (!set.quiet) report(all, set, files);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
