/// What the parts of fill_demo share: its settings, a particle, and what each way to fill reports.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lab/math.hpp"
#include "lab/options.hpp"
#include "lab/polygon.hpp"
#include "lab/study.hpp"

namespace mpm::filling {

struct Settings : Study {
    std::string way = "cells", region = "disks", weight = "points", polygon, image, levels, background = "none";
    std::vector<int> cells{20};
    int ppc = 2, samples = 8, corners = 60, pixels = 120, seeds = 300, iterations = 50, start = 1;
    double rho = 1, size = 0.1, angle = 20, width = 1, tolerance = 255;
};

/// All that this program asks of a particle.
struct Particle {
    Vec<2> x = Vec<2>::Zero();
    double V = 0, m = 0;  // volume, mass
    int material = 0;
};

/// One set of particles: their mass beside the exact one, and how much placement may gain or lose.
struct Row {
    std::string what;
    int cells = 0;
    std::size_t particles = 0;
    double mass = 0, exact = 0, bound = 0;
};

struct Filled {
    std::vector<Row> rows;
    std::vector<std::string> notes, files;  // for the screen; written
};

/// Each checks all its input, then makes the folder and writes particles, what they fill, and fill_<way>.gp. Throw BadInput and
/// FileTrouble.
Filled fill_cells(const Settings& set, const std::string& folder);    // review figure 33
Filled fill_bounds(const Settings& set, const std::string& folder);   // review figure 34
Filled fill_mesh(const Settings& set, const std::string& folder);     // review figure 35
Filled fill_image(const Settings& set, const std::string& folder);    // review figure 36
Filled fill_voronoi(const Settings& set, const std::string& folder);  // cells of review figure 29

using Segments = std::vector<std::pair<Vec<2>, Vec<2>>>;  // both ends of each
void add_outline(const Outline& outline, Segments& segments);
/// Edges of Triangles or PolygonCells, each once.
template <class Mesh> Segments edges_of(const Mesh& mesh) {
    std::vector<std::pair<int, int>> edges;
    for (const auto& corners : mesh.corners)
        for (std::size_t k = 0; k < corners.size(); ++k) edges.push_back(std::minmax(corners[k], corners[(k + 1) % corners.size()]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    Segments segments;
    for (const auto& [a, b] : edges)
        segments.push_back({mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)]});
    return segments;
}
/// Adds the file to `files`: x,y,V,m,material of each particle; x,y,dx,dy of each segment.
void write_particles(const std::string& path, const std::vector<Particle>& particles, std::vector<std::string>& files);
void write_segments(const std::string& path, const Segments& segments, std::vector<std::string>& files);

/// The row of these particles. `bound` is a mass.
Row row_of(const std::string& what, int cells, const std::vector<Particle>& particles, double exact, double bound);

/// Two panels beside each other, x and y in one scale.
inline constexpr const char* panels = R"(set multiplot layout 1,2
set size ratio -1
unset key
set xlabel 'x [length]'
set ylabel 'y [length]'
)";

}  // namespace mpm::filling
