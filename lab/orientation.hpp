/// On which side of a line a point lies, without rounding error.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "lab/math.hpp"

namespace mpm {

/// Sign of the area of the triangle a, b, c: 1 if counterclockwise, -1 if clockwise, 0 if and only if they lie on one line. Coordinates
/// must be such that their products neither overflow nor fall under 1e-290. Exact by sums of products split into value and rounding error
/// (Shewchuk 1997), where plain arithmetic cannot tell.
inline int orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]), plain = left - right;
    if (std::abs(plain) > 4e-16 * (std::abs(left) + std::abs(right))) return plain > 0 ? 1 : -1;

    std::array<double, 13> sum{};  // of parts that do not overlap, from small to large
    std::size_t n = 0;
    const auto add = [&](double x) {
        for (std::size_t i = 0; i < n; ++i) {  // value and rounding error of x + sum[i] (Knuth)
            const double value = x + sum[i], share = value - x;
            sum[i] = (x - (value - share)) + (sum[i] - share);
            x = value;
        }
        sum[n++] = x;
    };
    const auto add_product = [&](double x, double y) {
        add(std::fma(x, y, -(x * y)));
        add(x * y);
    };
    add_product(a[0], b[1]), add_product(-a[1], b[0]);
    add_product(b[0], c[1]), add_product(-b[1], c[0]);
    add_product(c[0], a[1]), add_product(-c[1], a[0]);
    while (n > 0 && sum[n - 1] == 0) --n;
    return n == 0 ? 0 : sum[n - 1] > 0 ? 1 : -1;
}

}  // namespace mpm
