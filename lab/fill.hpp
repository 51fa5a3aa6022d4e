/// Where the points of a cell lie, and how much of the cell each stands for.
#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace mpm {

/// Points of one cell along one axis: places from its lower end and parts that sum to one, both in cells.
struct CellRule {
    std::vector<double> at, part;
    explicit CellRule(std::size_t n) : at(n), part(n) {}
};

/// The middles of n equal parts.
inline CellRule middles(int n) {
    CellRule rule(static_cast<std::size_t>(n));
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
        rule.at[q] = (static_cast<double>(q) + 0.5) / n;
        rule.part[q] = 1.0 / n;
    }
    return rule;
}

/// The n Gauss-Legendre points, exact for polynomials of degree 2n - 1: zeros of the Legendre polynomial P_n by Newton's method, from
/// starts that lie nearest to theirs.
inline CellRule gauss_points(int n) {
    CellRule rule(static_cast<std::size_t>(n));
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
        double z = -std::cos(std::numbers::pi * (static_cast<double>(q) + 0.75) / (n + 0.5)), slope = 1;
        for (int i = 0; i < 10; ++i) {  // doubles its digits each time, from two
            double below = 0, p = 1;    // P_(k-1), P_k at z
            for (int k = 0; k < n; ++k) {
                const double above = ((2 * k + 1) * z * p - k * below) / (k + 1);
                below = p;
                p = above;
            }
            slope = n * (z * p - below) / (z * z - 1);
            z -= p / slope;
        }
        rule.at[q] = (1 + z) / 2;
        rule.part[q] = 1 / ((1 - z * z) * slope * slope);
    }
    return rule;
}

/// By name, as `--points` calls them.
inline CellRule cell_rule(const std::string& points, int n) { return points == "gauss" ? gauss_points(n) : middles(n); }

}  // namespace mpm
