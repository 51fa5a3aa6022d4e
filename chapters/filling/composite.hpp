/// The test image of fill_demo: a square of a composite with round fibres on a white background, with shades that differ from pixel to
/// pixel as those of a photograph do.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lab/image.hpp"

namespace mpm::filling {

inline const std::vector<Level>& composite_levels() {
    static const std::vector<Level> levels{{{0.95f, 0.80f, 0.45f}, 0}, {{0.20f, 0.30f, 0.55f}, 1}, {grey(1), Level::background}};
    return levels;
}

/// Random numbers 0 ... 1, the same in every run (Knuth and Lewis).
class Dice {
public:
    double throw_one() { return (state_ = 1664525u * state_ + 1013904223u) / 4294967296.0; }

private:
    std::uint32_t state_ = 1;
};

/// Centres of fibres of radius r in the unit square, 2.15 r apart or more: each place that chance offers is taken if it is free.
inline std::vector<Vec<2>> fibres(double r, Dice& dice) {
    std::vector<Vec<2>> centres;
    for (int attempt = 0; attempt < 4000; ++attempt) {
        const double x = dice.throw_one(), y = dice.throw_one();
        const Vec<2> c(x, y);
        if (std::all_of(centres.begin(), centres.end(), [&](const Vec<2>& o) { return (o - c).norm() >= 2.15 * r; })) centres.push_back(c);
    }
    return centres;
}

/// n x n pixels with levels that are whole numbers of 255, as files keep them.
inline Image composite(int n) {
    constexpr double r = 0.07, margin = 0.06;
    Dice dice;
    const std::vector<Vec<2>> centres = fibres(r, dice);
    Image image{n, n, {}};
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const Vec<2> x((column + 0.5) / n, (row + 0.5) / n);
            const bool fibre = std::any_of(centres.begin(), centres.end(), [&](const Vec<2>& c) { return (x - c).norm() <= r; });
            const bool outside = (x.array() < margin).any() || (x.array() > 1 - margin).any();
            Colour colour = composite_levels()[outside ? 2 : fibre ? 1 : 0].colour;
            const float shade = outside ? 0.0f : static_cast<float>(0.1 * (dice.throw_one() - 0.5));
            for (float& c : colour) c = std::round(255 * std::clamp(c + shade, 0.0f, 1.0f)) / 255;
            image.pixels.push_back(colour);
        }
    return image;
}

}  // namespace mpm::filling
