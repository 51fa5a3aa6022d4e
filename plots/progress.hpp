/// How far a sweep has come and how long it will take, on a terminal.
#pragma once
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "plots/sweep.hpp"

namespace mpm {

/// One line on stderr, drawn again a few times a second. A run is taken to cost as cells squared, which is right in one dimension.
class SweepProgress {
public:
    explicit SweepProgress(const std::vector<const Run*>& runs) : runs_(runs.size()) {
        for (const Run* run : runs) left_ += cost(*run);
    }
    ~SweepProgress() {
        if (drawn_) std::fprintf(stderr, "\r%100s\r", "");
    }
    SweepProgress(const SweepProgress&) = delete;
    SweepProgress& operator=(const SweepProgress&) = delete;

    void ended(const Run& run) {
        ++ended_;
        done_ += cost(run);
        left_ -= cost(run);
        passed_ = seconds(start_);
    }
    void show(const Run* running) {
        if (!terminal_ || running == nullptr || seconds(last_) < 0.2) return;
        last_ = Clock::now();
        drawn_ = true;
        char text[160];
        int n = std::snprintf(text, sizeof text, "%zu of %zu runs, now %s, %d cells, %.0f s", ended_, runs_, running->name.c_str(),
                              running->cells, seconds(start_));
        if (done_ > 0 && n < 130) {
            const double expected = left_ * passed_ / done_ - (seconds(start_) - passed_);
            std::snprintf(text + n, sizeof text - static_cast<std::size_t>(n), ", about %.0f s left", std::fmax(0, expected));
        }
        std::fprintf(stderr, "\r%-100.100s", text);
    }

private:
    using Clock = std::chrono::steady_clock;
    static double cost(const Run& run) { return static_cast<double>(run.cells) * run.cells; }
    static double seconds(Clock::time_point since) { return std::chrono::duration<double>(Clock::now() - since).count(); }
    bool terminal_ = isatty(STDERR_FILENO) == 1, drawn_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_;
    std::size_t runs_, ended_ = 0;
    double done_ = 0, left_ = 0, passed_ = 0;
};

}  // namespace mpm
