/// fill_demo: particles at the points of grid cells, of a triangle mesh, of Voronoi cells and of an image (review 4.1, figures 33 to 36;
/// 3.6.6), and how well their mass keeps area times density. Links CGAL's GPL packages (lab/mesh.hpp).
///   ./fill_demo --case mesh --size 0.1 --plot png
#include <cmath>
#include <cstdio>

#include "chapters/filling/filling.hpp"
#include "lab/figure.hpp"
#include "lab/program.hpp"

namespace mpm::filling {

void add_outline(const Outline& outline, Segments& segments) {
    for (std::size_t i = 0; i < outline.size(); ++i) segments.push_back({outline[i], outline[(i + 1) % outline.size()]});
}

void write_particles(const std::string& path, const std::vector<Particle>& particles, std::vector<std::string>& files) {
    Csv<5> file(path, {"x", "y", "V", "m", "material"});
    for (const Particle& p : particles) file.row(p.x[0], p.x[1], p.V, p.m, p.material);
    files.push_back(path);
}

void write_segments(const std::string& path, const Segments& segments, std::vector<std::string>& files) {
    Csv<4> file(path, {"x", "y", "dx", "dy"});
    for (const auto& [a, b] : segments) file.row(a[0], a[1], b[0] - a[0], b[1] - a[1]);
    files.push_back(path);
}

Row row_of(const std::string& what, int cells, const std::vector<Particle>& particles, double exact, double bound) {
    double mass = 0;
    for (const Particle& p : particles) mass += p.m;
    return {what, cells, particles.size(), mass, exact, bound};
}

}  // namespace mpm::filling

using namespace mpm;
using filling::Filled;
using filling::Settings;

namespace {

constexpr const char* program = "fill_demo";
constexpr const char* purpose = "particles of regions, meshes and images";

void declare(Options& o, Settings& set) {
    o.choice("case", set.way, {"cells", "bounds", "mesh", "voronoi", "image"},
             "points of cells, of the cells in reach, of triangles, of Voronoi cells, of pixels");
    o.choice("region", set.region, {"disks", "ring", "plate"}, "what is filled (cells)");
    o.text("polygon", set.polygon,
           "file of a polygon to fill instead: x, y of a corner in each line, holes after an empty line (cells, mesh, voronoi)");
    o.contradict("polygon", "region");
    o.integers("cells", set.cells, "cells", between(1, 5000), "cells across the region's square (cells)");
    o.integer("ppc", set.ppc, "-", between(1, 100), "points per cell and direction (cells, bounds)");
    o.choice("weight", set.weight, {"points", "share"},
             "volume of a point: its part of the cell, or what the region shares with that (cells)");
    o.integer("samples", set.samples, "-", between(1, 1000), "to each side of a part, where the shared area is not exact (cells)");
    o.integer("corners", set.corners, "-", between(3, 1000000), "corners of the disk (mesh)");
    o.number("size", set.size, "length", above(0), "longest edge of a triangle (mesh)");
    o.number("angle", set.angle, "degree", between(0, 20.7), "smallest angle of a triangle (mesh)");
    o.integer("seeds", set.seeds, "-", between(1, 5000000), "of Voronoi cells (voronoi)");
    o.integer("iterations", set.iterations, "-", between(0, 1000000), "of Lloyd's method: seeds to centroids (voronoi)");
    o.integer("start", set.start, "-", between(0, 2147483647), "number of the random places that seeds start from (voronoi)");
    o.text("image", set.image, "PGM, PPM or PNG file; empty: a composite made here (image)");
    o.text("levels", set.levels, "colours of materials 0, 1, ...: grey 0 ... 255 or rrggbb, with commas; empty: 0,255 (image)");
    o.text("background", set.background, "colour of which no particles are made, or none (image)");
    o.number("tolerance", set.tolerance, "-", between(0, 255), "largest difference of a colour from its level (image)");
    o.number("width", set.width, "length", above(0), "of the image (image)");
    o.integer("pixels", set.pixels, "-", between(2, 5000), "of the composite, to each side (image)");
    o.number("rho", set.rho, "mass/length^2", above(0), "density");
    set.declare(o);
}

/// Options that another case has, or another choice within this one, are refused by name.
void check_used(const Settings& set) {
    const Settings standard;
    const bool cells = set.way == "cells", mesh = set.way == "mesh", image = set.way == "image", voronoi = set.way == "voronoi";
    const auto check = [](const char* name, bool differs, bool used, const char* user) {
        if (differs && !used) throw BadInput(std::string("--") + name + ": only " + user + " uses it");
    };
    check("region", set.region != standard.region, cells, "--case cells");
    check("polygon", !set.polygon.empty(), cells || mesh || voronoi, "--case cells, mesh or voronoi");
    check("cells", set.cells != standard.cells, cells, "--case cells");
    check("ppc", set.ppc != standard.ppc, cells || set.way == "bounds", "--case cells or bounds");
    check("weight", set.weight != standard.weight, cells, "--case cells");
    check("samples", set.samples != standard.samples, cells && set.weight == "share", "--case cells with --weight share");
    check("corners", set.corners != standard.corners, mesh && set.polygon.empty(), "--case mesh without --polygon");
    check("size", set.size != standard.size, mesh, "--case mesh");
    check("angle", set.angle != standard.angle, mesh, "--case mesh");
    check("seeds", set.seeds != standard.seeds, voronoi, "--case voronoi");
    check("iterations", set.iterations != standard.iterations, voronoi, "--case voronoi");
    check("start", set.start != standard.start, voronoi, "--case voronoi");
    check("image", !set.image.empty(), image, "--case image");
    check("levels", !set.levels.empty(), image && !set.image.empty(), "--case image with --image");
    check("background", set.background != standard.background, image && !set.image.empty(), "--case image with --image");
    check("tolerance", set.tolerance != standard.tolerance, image, "--case image");
    check("width", set.width != standard.width, image, "--case image");
    check("pixels", set.pixels != standard.pixels, image && set.image.empty(), "--case image without --image");
}

Filled fill(const Settings& set, const std::string& folder) {
    if (set.way == "cells") return filling::fill_cells(set, folder);
    if (set.way == "bounds") return filling::fill_bounds(set, folder);
    if (set.way == "mesh") return filling::fill_mesh(set, folder);
    return set.way == "voronoi" ? filling::fill_voronoi(set, folder) : filling::fill_image(set, folder);
}

void write_table(const std::string& path, const Filled& filled) {
    CsvFile table(path, {"particles_of", "cells", "particles", "mass", "mass_exact", "difference", "bound"});
    for (const auto& row : filled.rows)
        table.row({row.what, std::to_string(row.cells), std::to_string(row.particles), number_text(row.mass), number_text(row.exact),
                   number_text(row.mass - row.exact), number_text(row.bound)});
}

void report(const Filled& filled) {
    std::printf("%s: %s\n", program, purpose);
    for (const std::string& note : filled.notes) std::printf("%s\n", note.c_str());
    std::printf("particles     cells  particles          mass  area x density  difference  relative  stated bound\n");
    for (const auto& row : filled.rows)
        std::printf("%-12s %6s %10zu  %12.6g  %14.6g  %10.2e  %8.1e  %12.2e\n", row.what.c_str(),
                    row.cells > 0 ? std::to_string(row.cells).c_str() : "-", row.particles, row.mass, row.exact, row.mass - row.exact,
                    std::abs(row.mass / row.exact - 1), row.bound);
    say_written(filled.files);
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Settings set;
    declare(options, set);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    check_used(set);
    const std::string folder = run_folder(program, options, set.out, set.label);
    Filled filled = fill(set, folder);
    write_file(folder + "/run.ini", options.ini());
    write_table(folder + "/filling.csv", filled);
    filled.files.insert(filled.files.begin(), {folder + "/run.ini", folder + "/filling.csv"});
    add_picture(folder, "fill_" + set.way, set.plot, filled.files);
    if (!set.quiet) report(filled);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
