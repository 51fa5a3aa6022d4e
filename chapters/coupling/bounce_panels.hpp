/// The figure of a bouncing disk's history, the same for every way to compute it.
#pragma once
#include <vector>

#include "lab/figure.hpp"

namespace mpm {

inline std::vector<Panel> bounce_panels() {
    return {{"",
             "t",
             "time t [s]",
             "height of the centre [m]",
             {{"height", "computed", "lines dt solid lc rgb '#c03030'"},
              {"height_rigid", "rigid, without loss", "lines dt 2 lc rgb 'black'"}},
             ""},
            {"", "t", "time t [s]", "force on the plate [N/m]", {{"pressing", "computed", "lines dt solid lc rgb '#3060c0'"}}, ""}};
}

}  // namespace mpm
