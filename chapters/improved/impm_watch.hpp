/// What a run of the improved MPM counts and weighs: fits of a lower degree, and the mass of the grid against that of the particles.
#pragma once
#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "chapters/improved/mls.hpp"

namespace mpm {

struct ImpmWatch {
    std::atomic<long> lower = 0, none = 0;  // fits of a lower degree than asked for, and without any points
    long steps = 0;
    double largest_mass_error = 0;          // |mass of the nodes / mass of the particles - 1|

    void see(int degree, const MlsChoice& choice) {
        if (degree < choice.degree) [[unlikely]] {
            ++lower;
            if (degree < 0) ++none;
        }
    }
    template <class Body> void weigh(const Body& body) {
        double nodes = 0, particles = 0;
        for (const auto& node : body.grid) nodes += node.m;
        for (const auto& p : body.points) particles += p.m;
        largest_mass_error = std::max(largest_mass_error, std::abs(nodes / particles - 1));
        ++steps;
    }
    std::vector<std::pair<std::string, double>> facts() const {
        const double n = static_cast<double>(std::max(1L, steps));
        return {{"MLS fits of lower degree, per step", static_cast<double>(lower) / n},
                {"MLS fits without particles, per step", static_cast<double>(none) / n},
                {"mass of the grid, largest error", largest_mass_error}};
    }
};

}  // namespace mpm
