/// mls_approximation: a function known at random points of the unit segment, brought to equally spaced nodes by moving least squares
/// (mls.hpp; review appendix D.2, figures 98 and 99) with constant, linear and quadratic basis.
///   ./mls_approximation --function sine --points 0 --cells 20,40,80,160
#include "chapters/improved/mls.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "lab/figure.hpp"
#include "lab/norms.hpp"
#include "lab/program.hpp"
#include "lab/record.hpp"
#include "lab/study.hpp"

using namespace mpm;

namespace {

constexpr const char* program = "mls_approximation";
constexpr const char* purpose = "a function at random points, brought to nodes by moving least squares";
const std::vector<std::string> bases{"shepard", "linear", "quadratic"};

struct Settings : Study {
    std::string function = "linear", weight = "cubic";
    std::vector<int> cells{10};
    int points = 15, ppc = 2, seed = 4;
    double support = 2;
    double u(double x) const { return function == "linear" ? 1 + x : std::sin(std::numbers::pi * x); }
};

struct Sample {
    Vec<1> x;
    double u;
};

/// `points` anywhere on the segment or, if that is 0, `ppc` anywhere in each cell. The same numbers on every machine.
std::vector<Sample> samples(const Settings& set, int cells) {
    std::mt19937 random(static_cast<std::uint32_t>(set.seed));
    std::vector<Sample> all;
    const int parts = set.points > 0 ? 1 : cells, each = set.points > 0 ? set.points : set.ppc;
    for (int part = 0; part < parts; ++part)
        for (int q = 0; q < each; ++q) {
            const double x = (part + static_cast<double>(random()) / 4294967296.0) / parts;
            all.push_back({Vec<1>(x), set.u(x)});
        }
    return all;
}

struct Approximation {
    int cells = 0;
    std::vector<Sample> points;
    std::vector<std::vector<double>> at_nodes;  // of each basis
    std::vector<double> l2, largest;            // errors of each basis; a node without points makes them nan
    std::vector<MlsCounts> counts;
};

Approximation approximate(const Settings& set, int cells) {
    Approximation a{cells, samples(set, cells), {}, {}, {}, {}};
    const Lattice<1> lattice{Vec<1>(0.0), Vec<1>(1.0 / cells), {cells}};
    NearPoints<1> near;
    near.fill(lattice, a.points);
    for (int degree = 0; degree < static_cast<int>(bases.size()); ++degree) {
        const MlsChoice choice{degree, set.support, set.weight == "quartic"};
        auto& u = a.at_nodes.emplace_back();
        auto& counts = a.counts.emplace_back();
        double sum = 0, largest = 0;
        for (int I = 0; I < lattice.size(); ++I) {
            const Vec<1> x = lattice.position(I);
            const auto fit = mls_at<1>(choice, near, a.points, x, [](const Sample& p) { return Vec<1>(p.u); });
            counts.see(fit.degree, choice);
            u.push_back(fit.degree < 0 ? std::nan("") : fit.values[0]);
            const double error = std::abs(u.back() - set.u(x[0]));
            sum += error * error / lattice.size();
            if (!(error <= largest)) largest = error;
        }
        a.l2.push_back(std::sqrt(sum));
        a.largest.push_back(largest);
    }
    return a;
}

void declare(Options& o, Settings& set) {
    o.choice("function", set.function, {"linear", "sine"}, "1 + x, or sin(pi x)");
    o.integers("cells", set.cells, "cells", between(1, 100000000), "cells of the unit segment; a list runs each");
    o.integer("points", set.points, "-", between(0, 100000000), "random points of the segment; 0: --ppc of them in each cell");
    o.integer("ppc", set.ppc, "-", between(1, 1000), "random points in each cell, with --points 0");
    o.number("support", set.support, "cells", between(0.1, 1000), "radius of the weight's support");
    o.choice("weight", set.weight, {"cubic", "quartic"}, "spline that weighs the points (D.6, D.7)");
    o.integer("seed", set.seed, "-", between(0, 1000000000), "of the random numbers");
    set.declare(o);
}

/// Order against the coarser grid before.
double order(const std::vector<Approximation>& all, std::size_t k, std::size_t basis) {
    if (k == 0) return std::nan("");
    return observed_order(all[k - 1].l2[basis], 1.0 / all[k - 1].cells, all[k].l2[basis], 1.0 / all[k].cells);
}

std::vector<std::string> write_files(const std::string& folder, const std::vector<Approximation>& all, const Settings& set,
                                     const Options& options) {
    std::vector<std::string> files{folder + "/run.ini", folder + "/points.csv", folder + "/nodes.csv", folder + "/convergence.csv"};
    write_file(files[0], options.ini());
    CsvFile points(files[1], {"x", "u"});  // of the coarsest grid
    for (const Sample& p : all.front().points) points.row({number_text(p.x[0]), number_text(p.u)});
    CsvFile nodes(files[2], {"x", "u_exact", "u_shepard", "u_linear", "u_quadratic"});
    for (int I = 0; I <= all.front().cells; ++I) {
        const double x = static_cast<double>(I) / all.front().cells;
        const auto& u = all.front().at_nodes;
        const auto i = static_cast<std::size_t>(I);
        nodes.row({number_text(x), number_text(set.u(x)), number_text(u[0][i]), number_text(u[1][i]), number_text(u[2][i])});
    }
    CsvFile table(files[3], {"cells", "h", "basis", "l2", "largest", "order", "fits", "lower", "none"});
    for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t b = 0; b < bases.size(); ++b)
            table.row({std::to_string(all[k].cells), number_text(1.0 / all[k].cells), bases[b], number_text(all[k].l2[b]),
                       number_text(all[k].largest[b]), number_text(order(all, k, b)), std::to_string(all[k].counts[b].fits),
                       std::to_string(all[k].counts[b].lower), std::to_string(all[k].counts[b].none)});
    const std::vector<Curve> curves{{"u_exact", "exact", "lines"},
                                    {"u_shepard", "constant basis (Shepard)", "linespoints"},
                                    {"u_linear", "linear basis", "points pt 6 ps 2"},
                                    {"u_quadratic", "quadratic basis", "points pt 4 ps 2"}};
    files.push_back(write_figure(folder, program, "nodes.csv", "Moving least squares at the nodes",
                                 {{"", "x", "x [length]", "u [-]", curves, "", "nodes.csv"}}, 1));
    return files;
}

void report(const std::vector<Approximation>& all, const std::vector<std::string>& files) {
    std::printf("%s: %s\n", program, purpose);
    std::printf("  cells  points  basis       rms error   order  largest error  fits of lower degree, without points\n");
    for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t b = 0; b < bases.size(); ++b)
            std::printf("%7d %7zu  %-10s %10.3e  %6.2f     %10.3e  %ld, %ld of %ld\n", all[k].cells, all[k].points.size(),
                        bases[b].c_str(), all[k].l2[b], order(all, k, b), all[k].largest[b], all[k].counts[b].lower, all[k].counts[b].none,
                        all[k].counts[b].fits);
    say_written(files);
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Settings set;
    declare(options, set);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const std::string folder = run_folder(program, options, set.out, set.label);
    std::vector<Approximation> all;
    for (const int cells : set.cells) all.push_back(approximate(set, cells));
    make_folder(folder);
    std::vector<std::string> files = write_files(folder, all, set, options);
    add_picture(folder, program, set.plot, files);
    if (!set.quiet) report(all, files);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
