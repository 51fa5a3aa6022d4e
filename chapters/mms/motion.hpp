/// The manufactured motion of the unit segment (review 6.2.1 and A.1) in closed form: displacement, velocity, stress and the body force
/// that it needs.
#pragma once
#include <cmath>
#include <numbers>

namespace mpm {

/// u = G sin(k pi X) sin(k c pi t) on 0 <= X <= 1 with c = sqrt(E/rho) (A.1, there k = 1), of a neo-Hookean solid in plane strain (A.3).
struct SegmentMotion {
    double G = 1e-4, E = 1e7, nu = 0.3, rho = 1000;  // amplitude [length], Young's modulus [stress], Poisson's ratio [-], initial density
    int mode = 1;                                    // k [-]

    double lambda() const { return E * nu / ((1 + nu) * (1 - 2 * nu)); }
    double mu() const { return E / (2 * (1 + nu)); }
    double k_pi() const { return mode * std::numbers::pi; }
    double omega() const { return k_pi() * std::sqrt(E / rho); }
    double period() const { return 2 * std::numbers::pi / omega(); }

    double u(double X, double t) const { return G * std::sin(k_pi() * X) * std::sin(omega() * t); }
    double v(double X, double t) const { return omega() * G * std::sin(k_pi() * X) * std::cos(omega() * t); }      // (A.2)
    double F(double X, double t) const { return 1 + k_pi() * G * std::cos(k_pi() * X) * std::sin(omega() * t); }   // (A.4)
    double P(double X, double t) const { return lambda() * std::log(F(X, t)) / F(X, t) + mu() * (F(X, t) - 1 / F(X, t)); }  // (A.3)

    /// Body force per mass (A.8): rho a = dP/dX + rho b, where dF/dX = -(k pi)^2 u and a = -omega^2 u.
    double b(double X, double t) const {
        const double f = F(X, t), per_f2 = 1 / (f * f);
        return k_pi() * k_pi() * u(X, t) / rho * (lambda() * per_f2 * (1 - std::log(f)) + mu() * (1 + per_f2) - E);
    }
    /// Where the point is now that started from X; and where a point started that is at x now, by Newton's method (x grows with X).
    double x(double X, double t) const { return X + u(X, t); }
    double X_of(double place, double t) const {
        double start = place;
        for (int i = 0; i < 50; ++i) {
            const double off = (x(start, t) - place) / F(start, t);
            start -= off;
            if (std::abs(off) < 1e-15) break;
        }
        return start;
    }
};

}  // namespace mpm
