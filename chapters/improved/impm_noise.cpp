/// impm_noise: what becomes of noise on the particles of the improved MPM (impm.hpp) in one period of the manufactured segment, with the
/// velocity gradient as printed and as mended; and the theory of an endless bar at rest whose particles lie off their places (notes.md).
///   ./impm_noise --support 1.1 --cells 64,128,256,512
#include "chapters/improved/impm_growth.hpp"
#include "chapters/improved/impm_noise.hpp"

#include <cstdio>

#include "lab/figure.hpp"
#include "lab/program.hpp"
#include "lab/record.hpp"
#include "lab/study.hpp"

using namespace mpm;

namespace {

constexpr const char* program = "impm_noise";
constexpr const char* purpose = "growth of noise on the particles of the improved MPM";
const std::vector<std::string> gradients{"hat", "linear"};

struct Settings : Study {
    std::vector<int> cells{64, 128, 256};
    Segment<false> scene;
    int ppc = 2;
    double support = 1.1, amplitude = 1e-10;
};

struct Row {
    int cells;
    std::vector<NoiseGrowth> of;  // each gradient
};

ImpmChoice choice_of(const Settings& set, const std::string& gradient) {
    ImpmChoice choice;
    choice.gradient = gradient;
    choice.mls.support = set.support;
    return choice;
}

void declare(Options& o, Settings& set) {
    set.scene.G = 0.05;
    o.integers("cells", set.cells, "cells", between(4, 100000), "cells of the segment; a list runs each");
    o.integer("ppc", set.ppc, "-", between(1, 100), "particles per cell");
    o.number("support", set.support, "cells", between(0.6, 10), "radius of the particles that a fit sees");
    o.number("amplitude", set.amplitude, "-", above(0), "of the noise, in parts of the largest velocity");
    o.number("G", set.scene.G, "length", above(0), "largest displacement; the segment has length 1");
    set.declare(o);
}

std::vector<std::string> write_files(const std::string& folder, const std::vector<Row>& rows, const Settings& set,
                                     const Options& options) {
    std::vector<std::string> files{folder + "/run.ini", folder + "/noise.csv", folder + "/theory.csv"};
    write_file(files[0], options.ini());
    CsvFile table(files[1], {"cells", "h", "hat", "linear", "hat_last", "linear_last", "crossings"});
    for (const Row& row : rows)
        table.row({std::to_string(row.cells), number_text(1.0 / row.cells), number_text(row.of[0].largest), number_text(row.of[1].largest),
                   number_text(row.of[0].last), number_text(row.of[1].last), number_text(row.of[1].crossings)});
    CsvFile theory(files[2], {"offset", "rate_hat", "rate_linear"});  // growth in the time of a sound wave through a cell, dt = 0.2 h/c
    for (int i = 0; i <= 24; ++i) {
        std::vector<std::string> values{number_text(0.01 * i)};
        for (const std::string& gradient : gradients)
            values.push_back(number_text(ImpmGrowth(choice_of(set, gradient), 0.01 * i, 0.2).largest_rate()));
        theory.row(values);
    }
    files.push_back(write_figure(
        folder, program, "noise.csv", "Growth of noise in one period",
        {{"", "cells", "cells", "largest growth of the rms noise [-]",
          {{"hat", "gradient of the hat functions", "linespoints"}, {"linear", "linear between cells", "linespoints"}}, "", "noise.csv"},
         {"", "offset", "offset of the particles [cells]", "growth rate [c/h]",
          {{"rate_hat", "gradient of the hat functions", "lines"}, {"rate_linear", "linear between cells", "lines"}}, "", "theory.csv"}}));
    return files;
}

void report(const std::vector<Row>& rows, const std::vector<std::string>& files) {
    std::printf("%s: %s\n  cells  crossings    gradient hat: largest, last   linear: largest, last\n", program, purpose);
    for (const Row& row : rows)
        std::printf("%7d  %9.1f      %12.3e %12.3e  %12.3e %12.3e\n", row.cells, row.of[1].crossings, row.of[0].largest, row.of[0].last,
                    row.of[1].largest, row.of[1].last);
    say_written(files);
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Settings set;
    declare(options, set);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    set.scene.check();
    const std::string folder = run_folder(program, options, set.out, set.label);
    std::vector<Row> rows;
    for (const int cells : set.cells) {
        Row& row = rows.emplace_back(Row{cells, {}});
        for (const std::string& gradient : gradients) {
            row.of.push_back(grow_noise(choice_of(set, gradient), set.scene, cells, set.ppc, set.amplitude));
        }
    }
    make_folder(folder);
    std::vector<std::string> files = write_files(folder, rows, set, options);
    add_picture(folder, program, set.plot, files);
    if (!set.quiet) report(rows, files);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
