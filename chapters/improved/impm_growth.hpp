/// Linear stability of the improved MPM (impm.hpp) on an endless bar at rest: how fast its fastest wave grows or fades when all particles
/// lie off the places they started from by the same part of a cell.
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "chapters/improved/impm_choice.hpp"
#include "lab/math.hpp"

namespace mpm {

/// In units of the cell size, the wave speed and the density, with two particles per cell at 1/4 + offset and 3/4 + offset, |offset| < 1/4.
/// A wave multiplies from cell to cell by exp(i k h): velocities and strains of a cell's two particles are all there is to know.
class ImpmGrowth {
public:
    ImpmGrowth(const ImpmChoice& choice, double offset, double courant) : choice_(choice), offset_(offset), dt_(courant) {}

    /// ln of the growth per step, divided by the step: growth in the time that a sound wave takes for a cell. 0 or less is stable. From the
    /// 2^22nd power of a step, by squaring: exact to 1e-5.
    double rate(double kh) const {
        Matrix power = step(kh);
        double ln = 0, part = 1;  // ln of the factors taken out of the power, each to the power of `part`
        for (int i = 0; i < 22; ++i, part /= 2) {
            const double norm = power.cwiseAbs().maxCoeff();
            ln += part * std::log(norm);
            power /= norm;
            power = (power * power).eval();
        }
        return (ln + part * std::log(power.cwiseAbs().maxCoeff())) / dt_;
    }
    /// The largest of the waves between twice and 400 times the length of a cell.
    double largest_rate() const {
        double largest = -1e300;
        for (int i = 1; i <= 200; ++i) largest = std::max(largest, rate(i / 200.0 * std::numbers::pi));
        return largest;
    }

private:
    using Complex = std::complex<double>;
    using Matrix = Eigen::Matrix<Complex, 4, 4>;
    using Row = Eigen::Matrix<Complex, 1, 4>;

    double place(int particle) const { return 0.25 + 0.5 * particle + offset_; }

    /// Weights of the cell's two particles in the fit at x, those of the other cells included by the wave.
    Eigen::Matrix<Complex, 1, 2> fit(double x, double kh) const {
        double s0 = 0, s1 = 0, s2 = 0;
        std::vector<double> r, w;
        const int far = static_cast<int>(choice_.mls.support) + 2;
        for (int cell = -far; cell <= far; ++cell)
            for (int q = 0; q < 2; ++q) {
                r.push_back((cell + place(q) - x) / choice_.mls.support);
                w.push_back(choice_.mls.weight(std::abs(r.back())));
                s0 += w.back(), s1 += w.back() * r.back(), s2 += w.back() * r.back() * r.back();
            }
        Eigen::Matrix<Complex, 1, 2> sum = Eigen::Matrix<Complex, 1, 2>::Zero();
        for (std::size_t i = 0; i < r.size(); ++i)
            sum[static_cast<int>(i % 2)] +=
                w[i] * (s2 - s1 * r[i]) / (s0 * s2 - s1 * s1) * std::polar(1.0, kh * (static_cast<int>(i / 2) - far));
        return sum;
    }

    /// One step of Algorithm 10 for velocities v_1, v_2 and strains e_1, e_2 (stress E e, lines 2-14), linear in both.
    Matrix step(double kh) const {
        const Complex next = std::polar(1.0, kh);
        Row force = Row::Zero(), velocity = Row::Zero();
        force.tail<2>() = (1.0 - 1.0 / next) * fit(0.5, kh);  // of node 0, whose mass is 1: stress of its cell less that of the one before
        velocity.head<2>() = fit(0, kh);
        const Row moved = velocity + dt_ * force;
        Matrix A = Matrix::Identity();
        for (int q = 0; q < 2; ++q) {
            const double x = place(q), aside = std::abs(x - 0.5);
            A.row(q) += ((1 - x) + x * next) * dt_ * force;
            const Complex between = choice_.gradient == "hat" ? 1.0 : 1 - aside + aside * (x > 0.5 ? next : 1.0 / next);
            A.row(2 + q) += dt_ * between * (next - 1.0) * moved;
        }
        return A;
    }

    ImpmChoice choice_;
    double offset_, dt_;
};

}  // namespace mpm
