// Particles of Voronoi cells, as polygonal CPDI takes them (review 3.6.6): of random seeds, and after Lloyd's method has made them alike.
#include "lab/voronoi.hpp"

#include <array>
#include <cstdio>
#include <limits>

#include "chapters/filling/filling.hpp"
#include "lab/figure.hpp"
#include "lab/program.hpp"

namespace mpm::filling {
namespace {

/// An angle bracket with a hole.
Polygon bracket() { return Polygon({{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, {circle({0.2, 0.2}, 0.1, 40)}); }

/// A row for each corner, the first corner again at the end, and a row without numbers after each cell.
void write_cells(const std::string& path, const PolygonCells& cells, std::vector<std::string>& files) {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    Csv<4> file(path, {"cell", "corners", "x", "y"});
    for (std::size_t i = 0; i < cells.corners.size(); ++i) {
        const auto& corners = cells.corners[i];
        for (std::size_t k = 0; k <= corners.size(); ++k) {
            const Vec<2>& x = cells.points[static_cast<std::size_t>(corners[k % corners.size()])];
            file.row(i, corners.size(), x[0], x[1]);
        }
        file.row(i, corners.size(), gap, gap);
    }
    files.push_back(path);
}

/// How far apart the sizes of cells are, and how many have 3, 4, ... corners.
std::string note_of(const std::string& what, const PolygonCells& mesh) {
    double least = Bounds::inf, most = 0;
    std::array<int, 11> with{};
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
        const double area = cell_moments(mesh.points, mesh.corners[i], i).area;
        least = std::min(least, area), most = std::max(most, area);
        ++with.at(mesh.corners[i].size());
    }
    char text[120];
    std::snprintf(text, sizeof text, "%s: largest cell %.1f times the smallest; of 3, 4, ... 10 corners:", what.c_str(), most / least);
    std::string note = text;
    for (std::size_t n = 3; n < with.size(); ++n) note.append(" ").append(std::to_string(with[n]));
    return note;
}

constexpr const char* drawing = R"(
unset grid
set style fill solid 1 noborder
colour(n) = word('#f0e442 #e69f00 #fdd0a2 #deebf7 #9ecae1 #4292c6 #b8a0d4 #8e5fb5', n - 2)
set key below horizontal samplen 1 width -0.6 maxrows 1 title 'corners of a cell'
set autoscale fix
set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03
set tics nomirror
do for [k in 'random relaxed'] {
    set title (k eq 'random' ? 'random seeds' : lloyd)
    plot for [n=3:10] 'cells_'.k.'.csv' using (column('corners') == n ? column('x') : NaN):(column('y')) \
         with filledcurves closed lc rgb colour(n) title sprintf('%d', n), \
         'edges_'.k.'.csv' using (column('x')):(column('y')):(column('dx')):(column('dy')) with vectors nohead dt solid lc rgb '#404040' \
         lw 1 notitle, \
         'particles_'.k.'.csv' using (column('x')):(column('y')) with points pt 7 ps size lc rgb 'black' notitle
}
unset multiplot
)";

}  // namespace

Filled fill_voronoi(const Settings& set, const std::string& folder) {
    const Polygon domain = set.polygon.empty() ? bracket() : read_polygon(set.polygon);
    const double exact = set.rho * domain.area();
    const auto made = [&](int iterations) {
        return centroidal_voronoi(domain, set.seeds, {iterations, 0, static_cast<std::uint64_t>(set.start)});
    };
    const CentroidalCells random = made(0), relaxed = made(set.iterations);
    Filled filled;
    const std::vector<std::pair<std::string, const CentroidalCells*>> both{{"random", &random}, {"relaxed", &relaxed}};
    make_folder(folder);
    for (const auto& [name, cells] : both) {
        const auto particles = particles_at_centroids<Particle>(cells->cells, set.rho);
        filled.rows.push_back(row_of(name, 0, particles, exact, 0));
        filled.notes.push_back(note_of(name, cells->cells));
        write_particles(folder + "/particles_" + name + ".csv", particles, filled.files);
        write_cells(folder + "/cells_" + name + ".csv", cells->cells, filled.files);
        write_segments(folder + "/edges_" + name + ".csv", edges_of(cells->cells), filled.files);
    }
    const std::string count = std::to_string(relaxed.iterations);
    const double across = (domain.bounds().high - domain.bounds().low).maxCoeff(), spacing = std::sqrt(domain.area() / set.seeds) / across;
    filled.files.push_back(write_drawing(folder, "fill_voronoi", 1500, 850,
                                         std::string(panels) + "lloyd = 'after " + count + " iterations of Lloyd''s method'\nsize = " +
                                             number_text(std::clamp(12 * spacing, 0.1, 1.0)) + drawing));
    return filled;
}

}  // namespace mpm::filling
