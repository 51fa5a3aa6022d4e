/// A mesh between the particles of a snapshot (review 4.5): triangles that fill the bodies and leave gaps and holes open.
#pragma once
#include <string>
#include <vector>

#include "lab/snapshot.hpp"
#include "lab/triangulate.hpp"

namespace mpm {

/// A snapshot as it was written: every column a number. Throws FileTrouble, and BadInput for a file that is no snapshot in 2D.
Snapshot read_snapshot(const std::string& path);

struct ParticleMesh {
    std::vector<Triangle> triangles;  // rows of the snapshot
    double max_edge = 0;              // [length]
    std::size_t dropped = 0;          // triangles with a longer edge
};

/// Triangulates each body of its own and drops triangles with an edge longer than `max_edge` [length]; 0: twice the median edge. `name` is
/// the snapshot's, for messages. Throws BadInput where particles make no triangle: fewer than three, all on one line, two at one place, a place
/// that is not a number, or no triangle left.
ParticleMesh mesh_of(const Snapshot& particles, const std::string& name, double max_edge = 0);

/// Writes folder/name.dat, the triangles as gnuplot's blocks with the mean of `colour` at their corners, and folder/name.gp, which draws
/// them. Returns both paths. Throws FileTrouble.
std::vector<std::string> write_mesh_figure(const std::string& folder, const std::string& name, const std::string& title,
                                           const Snapshot& particles, const std::vector<Triangle>& triangles, const std::string& colour);

}  // namespace mpm
