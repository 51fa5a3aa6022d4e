/// The exact solution of the Riemann problem of an ideal gas, for any two states, vacuum included (Toro, Riemann Solvers and Numerical
/// Methods for Fluid Dynamics, chapter 4). Any consistent units.
#pragma once
#include <algorithm>
#include <cmath>

namespace mpm {

struct GasState {
    double rho = 0, u = 0, p = 0;  // density, velocity, pressure; rho = 0: vacuum
    double energy(double gamma) const { return rho > 0 ? p / ((gamma - 1) * rho) : 0; }  // specific internal energy
    double sound_speed(double gamma) const { return rho > 0 ? std::sqrt(gamma * p / rho) : 0; }
};

/// Two uniform states that meet at x = 0, t = 0; the solution depends on x/t alone.
class Riemann {
public:
    /// Densities and pressures must not be negative, gamma > 1.
    Riemann(const GasState& left, const GasState& right, double gamma)
        : left_{left, gamma}, right_{{right.rho, -right.u, right.p}, gamma} {
        vacuum_ = left.rho <= 0 || right.rho <= 0 || left_.escape() + right_.escape() <= 0;
        if (vacuum_) return;
        const auto excess = [&](double p) { return left_.drop(p) + right_.drop(p) + right.u - left.u; };
        double low = 0, high = std::max(left.p, right.p);
        while (excess(high) < 0) high = 2 * high + 1e-300;
        for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2)
            (excess(middle) < 0 ? low : high) = middle;
        p_ = high;
        u_ = (left.u + right.u + right_.drop(p_) - left_.drop(p_)) / 2;
    }

    bool vacuum() const { return vacuum_; }  // whether there is one between the waves, or one state is
    double p_star() const { return p_; }     // between the waves; 0 with vacuum
    double u_star() const { return u_; }     // likewise
    double rho_left() const { return left_.behind(p_); }   // beside the contact
    double rho_right() const { return right_.behind(p_); }
    /// Speeds of the outermost waves, to the left and to the right.
    double first() const { return left_.K.rho > 0 ? -left_.speed(p_) : -right_.escape(); }
    double last() const { return right_.K.rho > 0 ? right_.speed(p_) : left_.escape(); }

    /// The state at x/t. A vacuum has density, pressure and, by convention, the velocity x/t.
    GasState at(double xi) const {
        if (vacuum_) {
            if (left_.K.rho > 0 && xi < left_.escape()) return left_.fan(xi);
            if (right_.K.rho > 0 && -xi < right_.escape()) return mirrored(right_.fan(-xi));
            return {0, xi, 0};
        }
        return xi < u_ ? left_.at(xi, p_, u_) : mirrored(right_.at(-xi, p_, -u_));
    }

    /// Largest speed of sound and largest |u| of the solution, outside of vacuum.
    double fastest_sound() const {
        double c = std::max(left_.c(), right_.c());
        if (!vacuum_)
            for (const double rho : {rho_left(), rho_right()}) c = std::max(c, GasState{rho, 0, p_}.sound_speed(left_.gamma));
        return c;
    }
    double fastest_flow() const {
        double u = std::max(std::abs(left_.K.u), std::abs(right_.K.u));
        if (!vacuum_) return std::max(u, std::abs(u_));
        if (left_.K.rho > 0) u = std::max(u, std::abs(left_.escape()));
        return right_.K.rho > 0 ? std::max(u, std::abs(right_.escape())) : u;
    }

private:
    static GasState mirrored(const GasState& s) { return {s.rho, -s.u, s.p}; }

    /// The wave that goes to the left; the one to the right is its mirror image.
    struct Wave {
        GasState K;  // before the wave
        double gamma;

        double c() const { return K.sound_speed(gamma); }
        /// How much slower the gas is behind the wave, where the pressure is p: Toro's f_K.
        double drop(double p) const {
            if (p > K.p) return (p - K.p) / flux(p);
            return K.p > 0 ? 2 * c() / (gamma - 1) * (std::pow(p / K.p, (gamma - 1) / (2 * gamma)) - 1) : 0;
        }
        /// Mass that crosses a shock.
        double flux(double p) const { return std::sqrt(K.rho * ((gamma + 1) * p + (gamma - 1) * K.p) / 2); }
        double behind(double p) const {
            const double g = (gamma - 1) / (gamma + 1);
            return p > K.p ? K.rho * (p + g * K.p) / (g * p + K.p) : K.p > 0 ? K.rho * std::pow(p / K.p, 1 / gamma) : K.rho;
        }
        /// Velocity of a front that expands into vacuum.
        double escape() const { return K.u + 2 * c() / (gamma - 1); }

        GasState at(double xi, double p, double u) const {
            const GasState star{behind(p), u, p};
            if (p > K.p) return xi < K.u - flux(p) / K.rho ? K : star;
            return xi < u - star.sound_speed(gamma) ? fan(xi) : star;
        }
        /// The state before a rarefaction, or in it.
        GasState fan(double xi) const {
            if (xi <= K.u - c()) return K;
            const double here = std::max(0.0, 2 / (gamma + 1) * (c() + (gamma - 1) / 2 * (K.u - xi))), part = here / c();
            return {K.rho * std::pow(part, 2 / (gamma - 1)), xi + here, K.p * std::pow(part, 2 * gamma / (gamma - 1))};
        }
        /// Of the outer end of the wave, away from the middle.
        double speed(double p) const { return p > K.p ? flux(p) / K.rho - K.u : c() - K.u; }
    };
    Wave left_, right_;  // the right one mirrored
    bool vacuum_ = false;
    double p_ = 0, u_ = 0;
};

}  // namespace mpm
