#include "lab/progress.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace mpm {
namespace {
double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
}  // namespace

Progress::Progress(bool active) : active_(active && isatty(STDOUT_FILENO) == 1), start_(now()), last_(start_) {}

Progress::~Progress() {
    if (drawn_) std::printf("\r%72s\r", "");
}

void Progress::at(double fraction) {
    if (!active_ || !(fraction > 0)) return;
    const double t = now();
    if (t - start_ < 1 || t - last_ < 0.2) return;
    last_ = t;
    drawn_ = true;
    std::printf("\r[%-40.*s] %3.0f %%, %.0f s left ", static_cast<int>(40 * fraction), "########################################", 100 * fraction,
                (t - start_) * (1 / fraction - 1));
    std::fflush(stdout);
}

}  // namespace mpm
