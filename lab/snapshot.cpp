#include "lab/snapshot.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "lab/record.hpp"

namespace mpm {
namespace {

/// The bytes of a number from the highest to the lowest, as legacy VTK wants them on every machine.
template <class Bits> void put(std::string& out, Bits bits) {
    for (int shift = 8 * (static_cast<int>(sizeof bits) - 1); shift >= 0; shift -= 8) out += static_cast<char>(bits >> shift & 0xFFu);
}
void put(std::string& out, double value) { put(out, std::bit_cast<std::uint64_t>(value)); }
void put_index(std::string& out, std::size_t index) { put(out, static_cast<std::uint32_t>(index)); }

std::string head(const std::string& title, const char* dataset) {
    return "# vtk DataFile Version 3.0\n" + one_line(title, 200) + "\nBINARY\nDATASET " + dataset + "\n";
}

/// A name without blanks, which VTK reads as one word.
std::string word(std::string name) {
    std::replace_if(name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
    return name;
}

template <class Value> void scalars(std::string& out, const std::string& name, std::size_t n, Value&& value) {
    out += "SCALARS " + word(name) + " double 1\nLOOKUP_TABLE default\n";
    for (std::size_t i = 0; i < n; ++i) put(out, value(i));
    out += '\n';
}
/// value(i, d) for d = 0, 1; the third component is zero.
template <class Value> void vectors(std::string& out, const std::string& name, std::size_t n, Value&& value) {
    out += "VECTORS " + word(name) + " double\n";
    for (std::size_t i = 0; i < n; ++i) put(out, value(i, 0)), put(out, value(i, 1)), put(out, 0.0);
    out += '\n';
}

/// A column's values, or zeros if there is none of this name.
struct Column {
    const Snapshot& s;
    std::size_t number;
    Column(const Snapshot& snapshot, const std::string& name) : s(snapshot), number(snapshot.find(name)) {}
    double operator()(std::size_t row) const { return number < s.columns.size() ? s.at(row, number) : 0.0; }
};

/// sigma of the columns whose names end in `suffix`; in 1D its one component. szz stays zero where no law tells it.
void tensors(std::string& out, const Snapshot& s, const std::string& suffix) {
    const bool line = s.find("sigma" + suffix) < s.columns.size();
    if (!line && s.find("sxx" + suffix) == s.columns.size()) return;
    const Column xx(s, (line ? "sigma" : "sxx") + suffix), yy(s, "syy" + suffix), xy(s, "sxy" + suffix), zz(s, "szz" + suffix);
    out += "TENSORS sigma" + suffix + (line ? "_tensor" : "") + " double\n";
    for (std::size_t i = 0; i < s.rows(); ++i)
        for (const double value : {xx(i), xy(i), 0.0, xy(i), yy(i), 0.0, 0.0, 0.0, zz(i)}) put(out, value);
    out += '\n';
}

std::string points(const Snapshot& s) {
    const Column x(s, "x"), y(s, "y");
    std::string out = "POINTS " + std::to_string(s.rows()) + " double\n";
    for (std::size_t i = 0; i < s.rows(); ++i) put(out, x(i)), put(out, y(i)), put(out, 0.0);
    return out + '\n';
}

/// Velocity and stress as what they are, and every column but places and velocities as a scalar too.
std::string point_data(const Snapshot& s) {
    const bool line = s.find("v") < s.columns.size();
    const Column vx(s, line ? "v" : "vx"), vy(s, "vy");
    std::string out = "POINT_DATA " + std::to_string(s.rows()) + "\n";
    for (const std::string& name : s.columns) {
        if (name == "x" || name == "y" || name == "v" || name == "vx" || name == "vy") continue;
        scalars(out, name, s.rows(), Column(s, name));
    }
    if (line || s.find("vx") < s.columns.size())
        vectors(out, "v", s.rows(), [&](std::size_t i, int d) { return d == 0 ? vx(i) : vy(i); });
    for (const char* suffix : {"", "_smooth"}) tensors(out, s, suffix);
    return out;
}

}  // namespace

std::size_t Snapshot::find(const std::string& column) const {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
}

namespace {
std::string csv_text(const Snapshot& s, bool parted) {
    std::string text;
    for (std::size_t c = 0; c < s.columns.size(); ++c) text.append(c > 0 ? "," : "").append(csv_field(s.columns[c]));
    text += '\n';
    for (std::size_t row = 0; row < s.rows(); ++row) {
        if (parted && row > 0 && s.at(row, 0) != s.at(row - 1, 0)) text += '\n';
        for (std::size_t c = 0; c < s.columns.size(); ++c) text.append(c > 0 ? "," : "").append(number_text(s.at(row, c)));
        text += '\n';
    }
    return text;
}
}  // namespace

void write_csv(const std::string& path, const Snapshot& snapshot) { write_file(path, csv_text(snapshot, false)); }
void write_polygons(const std::string& path, const Snapshot& corners) { write_file(path, csv_text(corners, true)); }

void write_vtk(const std::string& path, const std::string& title, const Snapshot& s) {
    std::string out = head(title, "POLYDATA") + points(s);
    const std::string n = std::to_string(s.rows());
    out += "VERTICES " + n + " " + std::to_string(2 * s.rows()) + "\n";
    for (std::size_t i = 0; i < s.rows(); ++i) put_index(out, 1), put_index(out, i);
    write_file(path, out + "\n" + point_data(s));
}

void write_vtk(const std::string& path, const std::string& title, const Snapshot& s,
               const std::vector<std::array<std::size_t, 3>>& triangles) {
    std::string out = head(title, "POLYDATA") + points(s);
    out += "POLYGONS " + std::to_string(triangles.size()) + " " + std::to_string(4 * triangles.size()) + "\n";
    for (const auto& triangle : triangles) {
        put_index(out, 3);
        for (const std::size_t corner : triangle) put_index(out, corner);
    }
    write_file(path, out + "\n" + point_data(s));
}

void write_vtk(const std::string& path, const std::string& title, const GridSnapshot& s) {
    const auto lacks = [&](const char* column) { return s.find(column) == s.columns.size(); };
    if (lacks("m") && lacks("C")) return write_vtk(path, title, static_cast<const Snapshot&>(s));
    const bool plane = s.find("y") < s.columns.size();
    const auto n = static_cast<std::size_t>(s.nodes[0]) * static_cast<std::size_t>(s.nodes[1]);
    const std::size_t bodies = s.rows() / n;
    const auto pair = [](double a, double b, const char* third) { return number_text(a) + " " + number_text(b) + third; };
    std::string out = head(title, "STRUCTURED_POINTS");
    out += "DIMENSIONS " + std::to_string(s.nodes[0]) + " " + std::to_string(s.nodes[1]) + " 1\n";
    out += "ORIGIN " + pair(s.origin[0], s.origin[1], " 0\nSPACING ") + pair(s.spacing[0], s.spacing[1], " 1\n");
    out += "POINT_DATA " + std::to_string(n) + "\n";
    const Column m(s, "m"), px(s, plane ? "mvx" : "mv"), py(s, "mvy");
    for (std::size_t b = 0; b < bodies; ++b) {
        const std::string of_body = bodies > 1 ? std::string("_").append(std::to_string(b)) : "";
        const std::size_t first = b * n;
        for (const char* name : {"m", "C", "T"})
            if (!lacks(name))
                scalars(out, name + of_body, n, [&, value = Column(s, name)](std::size_t i) { return value(first + i); });
        if (lacks("m")) continue;
        vectors(out, "v" + of_body, n, [&](std::size_t i, int d) {
            const double mass = m(first + i);
            return mass > 0 ? (d == 0 ? px : py)(first + i) / mass : 0.0;
        });
    }
    write_file(path, out);
}

void write_vtk_series(const std::string& path, const std::vector<std::pair<std::string, double>>& files) {
    std::string text = "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n";
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto& [name, t] = files[i];
        text += "    { \"name\" : \"" + name + "\", \"time\" : " + number_text(t) + " }" + (i + 1 < files.size() ? ",\n" : "\n");
    }
    write_file(path, text + "  ]\n}\n");
}

}  // namespace mpm
