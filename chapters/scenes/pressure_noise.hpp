/// How much a pressure oscillates: within the cells, and from cell to cell.
#pragma once
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "chapters/material/across.hpp"

namespace mpm {

/// Both relative to the root mean square of the pressure [-].
struct PressureNoise {
    double within = 0;   // rms difference of particles to their cell's mean
    double between = 0;  // rms difference of a cell's mean to the mean of its four neighbours, zero where it is linear
};

/// -lambda ln J/J, the part of a neo-Hookean solid's pressure that grows with lambda, of F or, where there is one, F-bar.
template <class Point> double volumetric_pressure(Point p, double lambda) {
    if constexpr (requires { p.F33; }) p.F *= p.F33;
    const double J = volume_ratio(p);
    return -lambda * std::log(J) / J;
}

/// Cells of size h, particles belonging to that in which `place(p)` lies. Of cells between low and high along x differences to the
/// neighbours are counted, if they have all four.
template <class Points, class Place, class Pressure>
PressureNoise pressure_noise(const Points& points, double h, double low, double high, Place&& place, Pressure&& pressure) {
    struct Cell {
        double sum = 0, sum2 = 0, n = 0;
        double mean() const { return sum / n; }
    };
    std::map<std::pair<int, int>, Cell> cells;
    double sum2 = 0, n = 0, within2 = 0, between2 = 0, inner = 0, means2 = 0;
    for (const auto& p : points) {
        const auto& x = place(p);
        Cell& cell = cells[{static_cast<int>(std::floor(x[0] / h)), static_cast<int>(std::floor(x[1] / h))}];
        const double value = pressure(p);
        cell.sum += value, cell.sum2 += value * value, ++cell.n;
        sum2 += value * value, ++n;
    }
    for (const auto& [at, cell] : cells) {
        within2 += cell.sum2 - cell.n * cell.mean() * cell.mean();
        means2 += cell.mean() * cell.mean();
        double around = 0;
        int neighbours = 0;
        for (const auto& [i, j] : std::array<std::pair<int, int>, 4>{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}})
            if (const auto other = cells.find({at.first + i, at.second + j}); other != cells.end())
                around += other->second.mean(), ++neighbours;
        if (neighbours < 4 || at.first * h < low || (at.first + 1) * h > high) continue;
        between2 += std::pow(cell.mean() - around / 4, 2), ++inner;
    }
    if (!(sum2 > 0)) return {};
    return {std::sqrt(std::abs(within2) / sum2),
            inner > 0 ? std::sqrt(between2 / inner / (means2 / static_cast<double>(cells.size()))) : 0};
}

}  // namespace mpm
