// Particles at the points of grid cells: regular beside Gauss points (review figure 33), and only in the cells that the bounds of a region
// touch (review figure 34).
#include <array>
#include <variant>

#include "chapters/filling/filling.hpp"
#include "lab/figure.hpp"
#include "lab/fill.hpp"
#include "lab/program.hpp"

namespace mpm::filling {
namespace {

using Plate = Difference<Box, Disk>;

/// What is filled: objects that do not overlap, with the area and the length of the boundary of all, and the square they lie in.
struct Objects {
    std::vector<std::variant<Disk, Ring, Plate, Polygon>> all;
    double area = 0, length = 0;
    int curves = 1;
    Vec<2> corner = Vec<2>::Zero();
    double side = 1;
    Segments outline;
};

void add_circle(const Disk& disk, Objects& objects) { add_outline(circle(disk.centre, disk.r, 360), objects.outline); }

Objects objects_of(const Settings& set) {
    Objects o;
    const Vec<2> middle(0.5, 0.5);
    if (!set.polygon.empty()) {
        const Polygon polygon = read_polygon(set.polygon);
        const Bounds b = polygon.bounds();
        o = {
            {polygon}, polygon.area(), polygon.perimeter(), static_cast<int>(polygon.outlines().size()), b.low, (b.high - b.low).maxCoeff(),
            {}};
        for (const Outline& outline : polygon.outlines()) add_outline(outline, o.outline);
    } else if (set.region == "disks") {  // review 6.1.2
        for (const double c : {0.2, 0.8}) {
            const Disk disk{Vec<2>(c, c), 0.2};
            o.all.emplace_back(disk);
            o.area += disk.area();
            o.length += disk.perimeter();
            add_circle(disk, o);
        }
        o.curves = 2;
    } else if (set.region == "ring") {
        const Ring ring{middle, 0.25, 0.45};
        o = {{ring}, ring.area(), ring.perimeter(), 2, Vec<2>::Zero(), 1, {}};
        for (const double r : {ring.inner, ring.outer}) add_circle({middle, r}, o);
    } else {
        const Box box{Vec<2>(0.1, 0.1), Vec<2>(0.9, 0.9)};
        const Disk hole{middle, 0.2};
        o = {{box - hole}, box.area() - hole.area(), box.perimeter() + hole.perimeter(), 2, Vec<2>::Zero(), 1, {}};
        add_outline({{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}}, o.outline);
        add_circle(hole, o);
    }
    return o;
}

/// The square of the objects, and a cell more above: rounding puts no corner beyond.
Lattice<2> lattice_of(const Objects& o, int cells) { return {o.corner, Vec<2>::Constant(o.side / cells), {cells + 1, cells + 1}}; }

std::vector<Particle> fill(const Objects& objects, const Lattice<2>& lattice, const CellRule& rule, const Settings& set) {
    std::vector<Particle> all;
    for (const auto& object : objects.all)
        std::visit(
            [&](const auto& shape) {
                const auto some = set.weight == "share" ? particles_by_share<Particle>(shape, lattice, rule, set.rho, set.samples)
                                                        : particles_inside<Particle>(shape, lattice, rule, set.rho);
                all.insert(all.end(), some.begin(), some.end());
            },
            object);
    return all;
}

/// What placement may gain or lose: nothing where the shared area is exact.
double bound(const Objects& objects, const Lattice<2>& lattice, const CellRule& rule, const Settings& set) {
    const bool share = set.weight == "share";
    const bool exact =
        share && std::visit([](const auto& shape) { return OverlapRegion<std::decay_t<decltype(shape)>>; }, objects.all.front());
    return exact ? 0 : set.rho * placement_error(lattice, rule, objects.length, objects.curves, share ? set.samples : 0);
}

Segments grid_lines(const Lattice<2>& lattice, int cells) {
    Segments lines;
    const Vec<2> low = lattice.origin(), h = lattice.h();
    for (int i = 0; i <= cells; ++i) {
        lines.push_back({low + Vec<2>(i * h[0], 0), low + Vec<2>(i * h[0], cells * h[1])});
        lines.push_back({low + Vec<2>(0, i * h[1]), low + Vec<2>(cells * h[0], i * h[1])});
    }
    return lines;
}

constexpr const char* drawing = R"(set xrange [@XRANGE@]
set yrange [@YRANGE@]
unset grid
do for [k in 'mid gauss'] {
    set title (k eq 'mid' ? 'regular: middles of equal parts' : 'Gauss points')
    plot 'grid.csv' using (column('x')):(column('y')):(column('dx')):(column('dy')) with vectors nohead dt solid lc rgb '#c8c8c8' lw 1, \
         'outline.csv' using (column('x')):(column('y')):(column('dx')):(column('dy')) \
         with vectors nohead dt solid lc rgb '#d55e00' lw 2.5, \
         'particles_'.k.'.csv' using (column('x')):(column('y')) with points pt 7 ps @SIZE@ lc rgb 'black'
}
unset multiplot
)";

std::string replaced(std::string text, const std::vector<std::pair<std::string, std::string>>& pairs) {
    for (const auto& [from, to] : pairs) text.replace(text.find(from), from.size(), to);
    return text;
}

std::string range(double low, double width) { return number_text(low - 0.03 * width) + ":" + number_text(low + 1.03 * width); }

}  // namespace

Filled fill_cells(const Settings& set, const std::string& folder) {
    const Objects objects = objects_of(set);
    Filled filled;
    std::vector<std::pair<std::string, std::vector<Particle>>> drawn;  // of the first resolution
    for (const int cells : set.cells)
        for (const std::string points : {"mid", "gauss"}) {
            const Lattice<2> lattice = lattice_of(objects, cells);
            const CellRule rule = cell_rule(points, set.ppc);
            auto particles = fill(objects, lattice, rule, set);
            filled.rows.push_back(row_of(points, cells, particles, set.rho * objects.area, bound(objects, lattice, rule, set)));
            if (drawn.size() < 2) drawn.emplace_back(points, std::move(particles));
        }
    make_folder(folder);
    const int cells = set.cells.front();
    for (const auto& [points, particles] : drawn) write_particles(folder + "/particles_" + points + ".csv", particles, filled.files);
    write_segments(folder + "/outline.csv", objects.outline, filled.files);
    write_segments(folder + "/grid.csv", grid_lines(lattice_of(objects, cells), cells), filled.files);
    const double spacing = 620.0 / cells / set.ppc;  // pixels
    filled.files.push_back(write_drawing(folder, "fill_cells", 1500, 800,
                                         panels + replaced(drawing, {{"@XRANGE@", range(objects.corner[0], objects.side)},
                                                                     {"@YRANGE@", range(objects.corner[1], objects.side)},
                                                                     {"@SIZE@", number_text(std::clamp(spacing / 30, 0.2, 1.3))}})));
    return filled;
}

Filled fill_bounds(const Settings& set, const std::string& folder) {
    constexpr int cells = 4;
    const Lattice<2> lattice(Vec<2>::Zero(), Vec<2>::Ones(), {cells, cells});
    const Polygon triangle({{0.3, 1.2}, {2.7, 1.45}, {1.55, 3.75}});
    const CellRule rule = middles(set.ppc);
    const auto particles = particles_inside<Particle>(triangle, lattice, rule, set.rho);
    const CellRange visited = cells_of(triangle.bounds(), lattice);
    std::vector<Particle> discarded;
    each_point(triangle.bounds(), lattice, rule, [&](const Vec<2>& x, const Bounds& box) {
        if (!triangle.inside(x)) discarded.push_back(particle_at<Particle>(x, (box.high - box.low).prod(), set.rho));
    });

    Filled filled;
    const double length = triangle.perimeter();
    filled.rows.push_back(row_of("mid", cells, particles, set.rho * triangle.area(), set.rho * placement_error(lattice, rule, length)));
    filled.notes.push_back(std::to_string(visited.size()) + " of " + std::to_string(cells * cells) + " cells visited, " +
                           std::to_string(discarded.size()) + " points there are outside");
    make_folder(folder);
    write_particles(folder + "/particles.csv", particles, filled.files);
    write_particles(folder + "/discarded.csv", discarded, filled.files);
    Segments outline, box;
    add_outline(triangle.outer(), outline);
    const Bounds b = triangle.bounds();
    add_outline({b.low, {b.high[0], b.low[1]}, b.high, {b.low[0], b.high[1]}}, box);
    write_segments(folder + "/outline.csv", outline, filled.files);
    write_segments(folder + "/bounds.csv", box, filled.files);
    write_segments(folder + "/grid.csv", grid_lines(lattice, cells), filled.files);
    CsvFile list(folder + "/cells.csv", {"i", "j", "e", "visited"});  // from zero; e = i + j n, review (4.1)
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const bool in = i >= visited.begin[0] && i < visited.end[0] && j >= visited.begin[1] && j < visited.end[1];
            const std::array<double, 4> row{double(i), double(j), double(i + cells * j), in ? 1.0 : 0.0};
            list.row(row.data(), row.size());
        }
    filled.files.push_back(list.path());
    filled.files.push_back(write_drawing(folder, "fill_bounds", 1500, 800, std::string(panels) + R"(set xrange [-0.1:4.1]
set yrange [-0.1:4.1]
unset grid
set xtics 1
set ytics 1
edges = "using (column('x')):(column('y')):(column('dx')):(column('dy')) with vectors nohead"
set title 'cells (i, j) and their number e = i + 4 j'
set macros
plot 'grid.csv' @edges dt solid lc rgb '#909090' lw 1.5, \
     'cells.csv' using (column('i') + 0.5):(column('j') + 0.62):(sprintf('(%d, %d)', column('i'), column('j'))) with labels, \
     'cells.csv' using (column('i') + 0.5):(column('j') + 0.32):(sprintf('%d', column('e'))) with labels tc rgb '#0072b2'
set title 'only cells that the bounds touch are visited'
set style fill solid 1 noborder
plot 'cells.csv' using (column('i') + 0.5):(column('j') + 0.5):(0.5 * column('visited')):(0.5 * column('visited')) \
     with boxxyerror lc rgb '#dbe9f6', \
     'grid.csv' @edges dt solid lc rgb '#909090' lw 1.5, \
     'bounds.csv' @edges lc rgb '#0072b2' lw 2 dt (6,4), \
     'outline.csv' @edges dt solid lc rgb '#d55e00' lw 3, \
     'discarded.csv' using (column('x')):(column('y')) with points pt 6 ps 1 lw 1.5 lc rgb '#707070', \
     'particles.csv' using (column('x')):(column('y')) with points pt 7 ps 1.1 lc rgb 'black'
unset multiplot
)"));
    return filled;
}

}  // namespace mpm::filling
