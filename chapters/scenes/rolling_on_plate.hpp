/// A disk rolls down an elastic plate (Aulisa and Capodaglio, 6.3): the disk of rolling_disk.hpp, the plate under y = 0 of finite elements.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "chapters/scenes/rolling_disk.hpp"

namespace mpm {

/// Plate of 20 x 1.6 in two layers (the printed 0.85 of each would make 1.7). Unsaid in the source, here: its lower face is held, its ends
/// are free, and gravity does not act on it.
struct RollingOnPlate : RollingDisk {
    static constexpr const char* name = "rolling-on-plate";
    static constexpr const char* solves = "an elastic disk rolls down an inclined elastic plate";
    static constexpr std::array<const char*, 6> columns{"path", "path_exact", "height", "slip", "pressing", "sinking"};
    static constexpr double plate_height = 1.6;

    double E_plate = 8.4e6;

    RollingOnPlate() { around = 600, layers = 24; }
    void declare(Options& o) {
        RollingDisk::declare(o);
        o.number("E-plate", E_plate, "stress", above(0), "Young's modulus of the plate; unless told, twice the disk's");
    }
    double wave_speed() const { return std::max(law().wave_speed(), fem_law().wave_speed()); }

    std::array<Lines, 2> lines(int cells) const {
        auto all = RollingDisk::lines(cells);
        const Lines plate = halved(even_lines(-plate_height, 0, 2), refinement(cells));
        all[1].insert(all[1].begin(), plate.begin(), plate.end() - 1);
        return all;
    }
    static int plate_rows(int cells) { return 2 << refinement(cells); }
    std::vector<char> reset_held(const Rectilinear<2>& grid) const {
        std::vector<char> all(static_cast<std::size_t>(grid.size()) * 2, 0);
        std::fill_n(all.end() - 2 * grid.nodes(0), 2 * grid.nodes(0), 1);
        return all;
    }
    std::vector<int> fem_elements(const Rectilinear<2>& grid) const {
        std::vector<int> all(static_cast<std::size_t>(grid.elements(0) * plate_rows(grid.elements(0))));
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    Law fem_law() const {
        Law plate = law();
        plate.lambda *= E_plate / E, plate.mu *= E_plate / E;
        return plate;
    }
    Vec<2> fem_body_force(double) const { return Vec<2>::Zero(); }

    /// Also the force that presses on the plate, and how deep it sinks in.
    template <class Points, class Plate> std::array<double, 6> watch(const Points& points, const Plate& plate, double t) const {
        const auto now = RollingDisk::watch(points, t);
        return {now[0], now[1], now[2], now[3], -plate.exchange().on_body[1], -plate.deepest(1)};
    }
};

}  // namespace mpm
