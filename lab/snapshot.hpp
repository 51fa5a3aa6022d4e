/// Snapshots: what particles or nodes tell at one moment, as named columns, and their files: CSV, and legacy VTK for ParaView.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace mpm {

/// Names of columns and their values, row after row. `body` is a row's body; `x`, `y` are places, `vx`, `vy` (in 1D `v`) velocities,
/// `sxx`, `syy`, `sxy`, `szz` (in 1D `sigma`) stresses; all others are scalars.
struct Snapshot {
    std::vector<std::string> columns;
    std::vector<double> values{};

    std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * columns.size() + column]; }
    /// Number of a column, or columns.size() if there is none of this name.
    std::size_t find(const std::string& column) const;
    template <std::size_t N> void add(const std::array<double, N>& row) { values.insert(values.end(), row.begin(), row.end()); }
};

/// The nodes of all bodies, body after body, on one lattice.
struct GridSnapshot : Snapshot {
    std::array<int, 2> nodes{1, 1};                 // along each axis
    std::array<double, 2> origin{}, spacing{1, 1};  // [length]
};

/// What snapshots are written as.
struct SnapshotFormat {
    bool csv = true, vtk = false;
};

/// Throws FileTrouble, as all below do.
void write_csv(const std::string& path, const Snapshot& snapshot);
/// Corners of polygons as CSV with an empty line between polygons, as gnuplot asks; the first column tells the polygons apart.
void write_polygons(const std::string& path, const Snapshot& corners);

/// Legacy VTK 3.0, binary: the particles as POLYDATA of vertices, with the vector v, the tensor sigma and all other columns as scalars.
/// `title` becomes one line of at most 255 characters.
void write_vtk(const std::string& path, const std::string& title, const Snapshot& particles);
/// The same with triangles between the particles instead of vertices.
void write_vtk(const std::string& path, const std::string& title, const Snapshot& particles,
               const std::vector<std::array<std::size_t, 3>>& triangles);
/// STRUCTURED_POINTS with mass m and velocity v of each body's nodes (m_0, v_0, m_1, ... if there are several), v = 0 where no mass is;
/// of nodes that carry heat, its capacity C and temperature T. Nodes with neither, those of a grid of elements, are written as particles are.
void write_vtk(const std::string& path, const std::string& title, const GridSnapshot& nodes);

/// name.vtk.series: the files in time, which ParaView opens as one.
void write_vtk_series(const std::string& path, const std::vector<std::pair<std::string, double>>& files);

}  // namespace mpm
