/// The area that polygons cover together.
#pragma once
#include <vector>

#include "lab/math.hpp"

namespace mpm {

/// Area that simple polygons cover together [length^2], exact but for rounding: in bands of y, by slabs between events, in which the covered
/// length is linear in x and its value in the middle exact. O(edges) for many small polygons.
double covered_area(const std::vector<std::vector<Vec<2>>>& polygons);

}  // namespace mpm
