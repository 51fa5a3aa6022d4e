/// Time steps, stopwatches and memory.
#pragma once
#include <chrono>

#include "lab/math.hpp"

namespace mpm {

/// Largest explicit step by review 2.7: min over the axes of h/(c + |v|). Any consistent units.
template <int D> double critical_step(const Vec<D>& h, double wave_speed, double speed) { return h.minCoeff() / (wave_speed + speed); }

/// Largest explicit step of heat conduction that the review names (5.3.3), 1/(2 kappa sum of 1/h^2 over the axes): h^2/(2 kappa) in 1D.
/// `kappa` is the diffusivity k/(rho c) [length^2/time].
template <int D> double conduction_step(const Vec<D>& h, double kappa) { return 1 / (2 * kappa * h.cwiseInverse().squaredNorm()); }

/// CPU seconds this process has used, and the peak of its memory in kB.
double cpu_seconds();
long peak_memory_kb();

/// Wall and CPU seconds of the method alone: runs between `start` and `stop`.
class Stopwatch {
public:
    void start() { wall0_ = std::chrono::steady_clock::now(), cpu0_ = cpu_seconds(); }
    void stop() {
        wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall0_).count();
        cpu += cpu_seconds() - cpu0_;
    }
    double wall = 0, cpu = 0;

private:
    std::chrono::steady_clock::time_point wall0_{};
    double cpu0_ = 0;
};

}  // namespace mpm
