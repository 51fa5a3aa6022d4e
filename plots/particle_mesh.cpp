/// particle_mesh: a Delaunay mesh between the particles of a snapshot (review 4.5), as legacy VTK and as a picture.
///   ./particle_mesh out/two_disks/default/particles_0002.csv --colour pressure --plot png
#include <cstdio>
#include <filesystem>

#include "lab/figure.hpp"
#include "lab/options.hpp"
#include "lab/program.hpp"
#include "lab/record.hpp"
#include "plots/particle_triangles.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "particle_mesh";

struct Settings {
    std::string file, colour, out, plot = "none";
    double max_edge = 0;
    bool quiet = false;

    void declare(Options& o) {
        o.text("file", file, "snapshot of particles in 2D, particles_NNNN.csv; may stand first without --file");
        o.number("max-edge", max_edge, "length", at_least(0), "triangles with a longer edge are left out; 0: twice the median edge");
        o.text("colour", colour, "column that colours the picture; empty: mises, or the last one");
        o.text("out", out, "folder of the files; empty: that of the snapshot");
        o.choice("plot", plot, {"none", "png", "svg", "pdf", "tikz"}, "picture to draw");
        o.flag("quiet", quiet, "say nothing but errors");
    }
};

std::string chosen_colour(const std::string& asked, const Snapshot& particles, const std::string& name) {
    const auto has = [&](const std::string& column) { return particles.find(column) < particles.columns.size(); };
    if (asked.empty()) return has("mises") ? "mises" : particles.columns.back();
    if (has(asked)) return asked;
    std::string known;
    for (const std::string& column : particles.columns) known += (known.empty() ? "" : ", ") + column;
    throw BadInput("--colour " + one_line(asked) + ": " + name + " has no such column, but " + known);
}

int mesh(const Settings& s) {
    if (s.file.empty()) throw BadInput("no snapshot: give its file first, as in: particle_mesh particles_0000.csv --plot png");
    const std::filesystem::path path(s.file);
    const std::string name = path.stem().string() + "_mesh", shown = one_line(s.file, 300);
    const std::string folder = !s.out.empty() ? s.out : path.has_parent_path() ? path.parent_path().string() : ".";
    const Snapshot particles = read_snapshot(s.file);
    const std::string colour = chosen_colour(s.colour, particles, shown);
    const ParticleMesh found = mesh_of(particles, shown, s.max_edge);
    make_folder(folder);
    std::vector<std::string> files{folder + "/" + name + ".vtk"};
    write_vtk(files.front(), name, particles, found.triangles);
    for (const std::string& file : write_mesh_figure(folder, name, name, particles, found.triangles, colour)) files.push_back(file);
    add_picture(folder, name, s.plot, files);
    if (s.quiet) return 0;
    std::printf("%s: %zu particles, %zu triangles, %zu left out with an edge longer than %.4g\nwritten:", shown.c_str(), particles.rows(),
                found.triangles.size(), found.dropped, found.max_edge);
    for (const std::string& file : files) std::printf(" %s", file.c_str());
    std::printf("\n");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] {
        Options options(program, "a Delaunay mesh between the particles of a snapshot\n       particle_mesh FILE.csv [--name value]...");
        Settings s;
        s.declare(options);
        std::vector<const char*> words(argv, argv + argc);
        std::string file;
        if (argc > 1 && argv[1][0] != '-') file = std::string("--file=") + argv[1], words[1] = file.c_str();
        options.parse(argc, words.data());
        return answered(options, program) ? 0 : mesh(s);
    });
}
