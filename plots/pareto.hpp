/// Who beats whom: runs by their error and their run time.
#pragma once

namespace mpm {

struct Cost {
    double error, seconds;
};

/// Whether `one` is as good and as fast as `other`, and better in something. Errors within one per cent count as equal: variants that do
/// the same arithmetic in another order differ by less.
inline bool beats(const Cost& one, const Cost& other) {
    constexpr double equal = 1.01;
    if (one.seconds < other.seconds) return one.error <= equal * other.error;
    return one.seconds == other.seconds && one.error < other.error;
}

}  // namespace mpm
