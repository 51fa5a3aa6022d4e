/// Faces of straight edges in the plane that meet only at their ends.
#pragma once
#include <vector>

#include "lab/math.hpp"

namespace mpm {

/// Each edge is two half-edges: number 2 e runs from a to b, 2 e + 1 back.
struct GraphEdge {
    int a, b;
};
/// The half-edges around each face, the face on their left; and the face of each half-edge. A face with holes has a list for each outline.
struct FaceLoops {
    std::vector<std::vector<int>> loops;
    std::vector<int> loop_of;
};
FaceLoops trace_faces(const std::vector<Vec<2>>& points, const std::vector<GraphEdge>& edges);

}  // namespace mpm
