/// Particles of a graded disk and a graded beam: a uniform core and layers that become finer towards the boundary (Aulisa and Capodaglio,
/// appendix A).
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "lab/math.hpp"
#include "lab/options.hpp"

namespace mpm {

/// A particle's place and the area that it stands for.
struct Placed {
    Vec<2> x;
    double V;
};

/// a of the widths d a, d a^2, ... d a^layers that add up to `width`, by bisection. Throws BadInput if they would have to grow.
inline double grading(double d, int layers, double width) {
    if (layers * d < width * (1 - 1e-12)) throw BadInput("--layers: fewer than width / spacing of the core make them grow outwards");
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double a = 0.5 * (low + high);
        double sum = 0, part = d;
        for (int k = 1; k <= layers; ++k) sum += (part *= a);
        (sum < width ? low : high) = a;
    }
    return 0.5 * (low + high);
}

/// Disk about the origin: rings in r <= R0 with `around` particles on the outermost, `layers` rings out to R. As printed, but for the areas
/// of the layers: each ring shares what lies between it and the ring within, so that all areas add up to pi R^2.
inline std::vector<Placed> graded_disk(double R, double R0, int around, int layers) {
    constexpr double pi = std::numbers::pi;
    std::vector<Placed> all{{Vec<2>(0, 0), 0}};
    const auto ring = [&](double r, int n, double V) {
        for (int j = 0; j < n; ++j) all.push_back({Vec<2>(r * std::cos(2 * pi * j / n), r * std::sin(2 * pi * j / n)), V});
    };
    const int rings = static_cast<int>(std::ceil(around / (2 * pi)));
    const double dR = R0 / rings;
    for (int i = 0; i < rings; ++i) {
        const double r = R0 - i * dR;
        ring(r, static_cast<int>(std::ceil(around * r / R0 * (1 - 1e-14))), 0);
    }
    for (Placed& p : all) p.V = pi * R0 * R0 / static_cast<double>(all.size());
    const double a = grading(dR, layers, R - R0);
    double inner = R0, width = dR, more = 1;
    for (int i = 1; i <= layers; ++i) {
        width *= a, more /= a;
        const double r = i == layers ? R : inner + width;
        const int n = static_cast<int>(std::ceil(around * more));
        ring(r, n, pi * (r * r - inner * inner) / n);
        inner = r;
    }
    return all;
}

/// Beam 0 < x < L, |y| < H/2: a core of height H0 with `rows` rows of particles, `layers` frames around it on all sides but that of x = 0.
/// Thickness and spacing of the frames shrink by the same factor, which is rounded up to three digits (1.148): so do the authors' programs,
/// whose count this is (appendix A keeps the spacing of the core). Core and frames share their areas evenly among their particles, the last
/// frame all that is left, so that all add up to L H.
inline std::vector<Placed> graded_beam(double L, double H, double H0, int rows, int layers) {
    std::vector<Placed> all;
    const double d = H0 / (rows - 1), L0 = L - (H - H0) / 2;
    const int columns = static_cast<int>(std::ceil(L0 / d)) + 1;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) all.push_back({Vec<2>(L0 * i / (columns - 1), H0 * (static_cast<double>(j) / (rows - 1) - 0.5)), 0});
    for (Placed& p : all) p.V = L0 * H0 / static_cast<double>(all.size());
    const double shrink = std::ceil(1000 / grading(d, layers, (H - H0) / 2)) / 1000;
    double inner_area = L0 * H0, across = d, along = L0 / (columns - 1), h = H0, l = L0;
    for (int i = 1; i <= layers; ++i) {
        across /= shrink, along /= shrink;
        h += 2 * across, l += along;
        const int high = static_cast<int>(std::ceil(h / across)) + 1, wide = static_cast<int>(std::ceil(l / along)) + 1;
        const std::size_t first = all.size();
        for (int j = 0; j < wide; ++j) all.push_back({Vec<2>(l * j / (wide - 1), h / 2), 0});
        for (int j = 1; j < high; ++j) all.push_back({Vec<2>(l, h / 2 - h * j / (high - 1)), 0});
        for (int j = 1; j < wide; ++j) all.push_back({Vec<2>(l - l * j / (wide - 1), -h / 2), 0});
        const double area = i == layers ? L * H : l * h;
        for (std::size_t p = first; p < all.size(); ++p) all[p].V = (area - inner_area) / static_cast<double>(all.size() - first);
        inner_area = area;
    }
    return all;
}

}  // namespace mpm
