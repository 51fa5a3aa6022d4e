/// grid_normals: normals on the nodes that a disk and the body around it share, by each way (normals.hpp; review figures 46 and 47), their
/// angles to the circle's, and how far both bodies' own are from one line.
///   ./grid_normals --cells 10 --plot png
///   ./grid_normals --cells 40 --offset-x 0.3 --offset-y 0.2
#include "chapters/contact/grid_normals.hpp"

#include <cstdio>

#include "lab/figure.hpp"
#include "lab/program.hpp"
#include "lab/record.hpp"
#include "lab/study.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "grid_normals";
constexpr const char* purpose = "normals on the nodes of a disk's boundary";
const std::vector<std::string> ways{"gradient", "volume", "density", "regression"};

std::vector<std::string> write_files(const std::string& folder, const NormalsSettings& s, const Options& options, bool quiet) {
    std::vector<std::string> files{folder + "/run.ini", folder + "/normals.csv"};
    write_file(files[0], options.ini());
    CsvFile table(files[1], {"normals", "nodes", "own_mean", "own_most",
                             "common_mean", "common_most", "non_collinear_mean", "non_collinear_most"});
    if (!quiet) std::printf("%-12s angle to the circle's, mean / most [degrees]: own  common  own of both against each other\n", "");
    for (const std::string& way : ways) {
        const std::vector<NodeNormals> all = normals_around(s, way);
        files.push_back(folder + "/nodes_" + way + ".csv");
        Csv<12> nodes(files.back(), {"x", "y", "nx", "ny", "mx", "my", "cx", "cy", "angle", "error_own", "error_common", "non_collinear"});
        for (const NodeNormals& at : all)
            nodes.row(at.x[0], at.x[1], at.own[0], at.own[1], at.other[0], at.other[1], at.common[0], at.common[1],
                      std::atan2(at.exact[1], at.exact[0]) * 180 / std::numbers::pi, at.error_own(), at.error_common(), at.non_collinear());
        const MeanMost own = over(all, &NodeNormals::error_own), common = over(all, &NodeNormals::error_common),
                       line = over(all, &NodeNormals::non_collinear);
        std::vector<std::string> row{way, std::to_string(all.size())};
        for (const double x : {own.mean, own.most, common.mean, common.most, line.mean, line.most}) row.push_back(number_text(x));
        table.row(row);
        if (!quiet)
            std::printf("%-12s %6.2f / %6.2f   %6.2f / %6.2f   %6.2f / %6.2f\n", way.c_str(), own.mean, own.most, common.mean, common.most,
                        line.mean, line.most);
    }
    std::vector<Curve> curves;
    for (const std::string column : {"error_own", "error_common"})
        curves.push_back({column, column == "error_own" ? "the disk's own" : "one for both", column == "error_own" ? "points pt 6" : "points pt 7"});
    std::vector<Panel> panels;
    for (const std::string& way : ways)
        panels.push_back({way, "angle", "place on the circle [degrees]", "angle to its normal [degrees]", curves,
                          "[-180:180]", "nodes_" + way + ".csv"});
    files.push_back(write_figure(folder, program, "nodes_gradient.csv", "Error of grid normals around a disk", panels, 2));
    return files;
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    NormalsSettings s;
    Study study;
    options.integer("cells", s.cells, "cells", between(4, 1000), "cells over the disk's diameter");
    options.integer("ppc", s.ppc, "-", between(1, 20), "particles per cell and direction");
    options.number("radius", s.radius, "length", above(0), "radius of the disk");
    options.number("offset-x", s.offset_x, "cells", between(-1, 1), "shift of the disk against the grid");
    options.number("offset-y", s.offset_y, "cells", between(-1, 1), "the same along y");
    options.number("density-ratio", s.ratio, "-", above(0), "density of the disk over that around it");
    options.choice("placing", s.placing, {"cells", "rings"}, "particles of the disk: those of cells, or in rings about its centre");
    options.choice("beside", s.beside, {"hole", "slab"}, "the other body: all around the disk, or a slab that it touches");
    study.declare(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const std::string folder = run_folder(program, options, study.out, study.label);
    make_folder(folder);
    std::vector<std::string> files = write_files(folder, s, options, study.quiet);
    add_picture(folder, program, study.plot, files);
    if (!study.quiet) say_written(files);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
