#include "plots/particle_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>

#include "lab/csv_read.hpp"
#include "lab/figure.hpp"
#include "lab/options.hpp"
#include "lab/gnuplot.hpp"
#include "lab/record.hpp"

namespace mpm {
namespace {

using Rows = std::vector<std::size_t>;
using Places = std::vector<std::array<double, 2>>;

/// The place of each row, all of them numbers.
Places places(const Snapshot& s, const std::string& name) {
    const std::size_t x = s.find("x"), y = s.find("y");
    Places all;
    for (std::size_t row = 0; row < s.rows(); ++row) {
        all.push_back({s.at(row, x), s.at(row, y)});
        for (const double c : all.back())
            if (!std::isfinite(c)) throw BadInput(name + ": row " + std::to_string(row + 1) + ": x or y is not a number");
    }
    return all;
}

/// Rows by body; all in one where the snapshot names none.
std::map<double, Rows> bodies_of(const Snapshot& s) {
    const std::size_t body = s.find("body");
    std::map<double, Rows> bodies;
    for (std::size_t row = 0; row < s.rows(); ++row) bodies[body < s.columns.size() ? s.at(row, body) : 0].push_back(row);
    return bodies;
}

void check_places(const Places& at, const Rows& rows, const std::string& name) {
    if (rows.size() < 3) throw BadInput(name + ": too few particles (" + std::to_string(rows.size()) + "), a triangle needs three");
    Rows sorted = rows;
    std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return at[a] < at[b]; });
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (at[sorted[i]] == at[sorted[i - 1]])
            throw BadInput(name + ": rows " + std::to_string(std::min(sorted[i], sorted[i - 1]) + 1) + " and " +
                           std::to_string(std::max(sorted[i], sorted[i - 1]) + 1) + " lie at the same place");
}

double length(const Places& at, std::size_t a, std::size_t b) { return std::hypot(at[a][0] - at[b][0], at[a][1] - at[b][1]); }
double longest_edge(const Places& at, const Triangle& t) {
    return std::max({length(at, t[0], t[1]), length(at, t[1], t[2]), length(at, t[2], t[0])});
}
double median_edge(const Places& at, const std::vector<Triangle>& triangles) {
    std::vector<double> edges;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) edges.push_back(length(at, t[k], t[(k + 1) % 3]));
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    std::nth_element(edges.begin(), middle, edges.end());
    return *middle;
}

struct Span {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double value) {
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
};

}  // namespace

Snapshot read_snapshot(const std::string& path) {
    const CsvTable table = read_csv(path);
    if (!table.has("x") || !table.has("y"))
        throw BadInput(one_line(path, 300) + ": has no columns x and y; particles_NNNN.csv of a 2D program has");
    Snapshot s{table.columns};
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        for (const std::string& column : table.columns) s.values.push_back(table.number(row, column));
    return s;
}

ParticleMesh mesh_of(const Snapshot& s, const std::string& name, double max_edge) {
    const Places at = places(s, name);
    const auto bodies = bodies_of(s);
    if (bodies.empty()) throw BadInput(name + ": too few particles (0), a triangle needs three");
    ParticleMesh mesh;
    for (const auto& [body, rows] : bodies) {
        const std::string who = bodies.size() > 1 ? name + ", body " + number_text(body) : name;
        check_places(at, rows, who);
        Places own;
        for (const std::size_t row : rows) own.push_back(at[row]);
        const std::vector<Triangle> triangles = triangulate(own);
        if (triangles.empty()) throw BadInput(who + ": all particles lie on one line");
        for (const Triangle& t : triangles) mesh.triangles.push_back({rows[t[0]], rows[t[1]], rows[t[2]]});
    }
    mesh.max_edge = max_edge > 0 ? max_edge : 2 * median_edge(at, mesh.triangles);
    mesh.dropped = std::erase_if(mesh.triangles, [&](const Triangle& t) { return longest_edge(at, t) > mesh.max_edge; });
    if (mesh.triangles.empty())
        throw BadInput("--max-edge " + number_text(mesh.max_edge) + ": every triangle of " + name + " has a longer edge");
    return mesh;
}

std::vector<std::string> write_mesh_figure(const std::string& folder, const std::string& name, const std::string& title,
                                           const Snapshot& s, const std::vector<Triangle>& triangles, const std::string& colour) {
    const std::size_t x = s.find("x"), y = s.find("y"), c = s.find(colour);
    std::string data = "# x,y,colour: each triangle two blocks of two points, its last corner twice\n";
    Span of_x, of_y, of_colour;
    for (const Triangle& t : triangles) {
        const double mean = (s.at(t[0], c) + s.at(t[1], c) + s.at(t[2], c)) / 3;
        of_colour.add(mean);
        for (const std::size_t k : {0, 1, 2, 2}) {
            of_x.add(s.at(t[k], x)), of_y.add(s.at(t[k], y));
            data += number_text(s.at(t[k], x)) + "," + number_text(s.at(t[k], y)) + "," + number_text(mean) + (k == 1 ? "\n\n" : "\n");
        }
        data += "\n\n";
    }
    if (!(of_colour.low <= of_colour.high)) of_colour.low = of_colour.high = 0;  // no value is a number
    write_file(folder + "/" + name + ".dat", data);
    const std::string script = detail::write_script(folder, name, [&](std::ostream& out) {
        const double width = of_x.high - of_x.low, height = of_y.high - of_y.low, edge = 0.03 * std::max(width, height);
        const double pixels = 700 / std::max(width, height);
        const double w = pixels * (width + 2 * edge), h = pixels * (height + 2 * edge), W = w + 280, H = h + 170;
        const auto range = [&](const Span& span) {
            return std::string("[").append(number_text(span.low - edge) + ":" + number_text(span.high + edge) + "]\n");
        };
        out << detail::script_start(name) << detail::script_terminal(name, number_text(std::ceil(W)), number_text(std::ceil(H)))
            << "set lmargin at screen " << 110 / W << "\nset rmargin at screen " << (110 + w) / W
            << "\nset tmargin at screen " << 1 - 80 / H << "\nset bmargin at screen " << 90 / H
            << "\nset colorbox user origin " << (130 + w) / W << "," << 90 / H << " size " << 25 / W
            << "," << h / H << "\nset title " << detail::label(title, true) << " noenhanced\n"
            << "set xlabel 'x [length]' offset 0,0.4\nset ylabel 'y [length]' offset 1,0\n"
            << "set xrange " << range(of_x) << "set yrange " << range(of_y) << "c1 = " << number_text(of_colour.low)
            << "; c2 = " << number_text(of_colour.high) << "\n"
            << detail::colour_scale(colour, column_label(colour))
            << "unset key\nset view map\nset pm3d border lc rgb '#606060' lw 0.3\n"
            << "splot " << detail::in_gnuplot(name + ".dat") << " using 1:2:(0):3 with pm3d\n";
    });
    return {folder + "/" + name + ".dat", script};
}

}  // namespace mpm
