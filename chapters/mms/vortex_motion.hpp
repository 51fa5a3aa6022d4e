/// The motion of the generalized vortex (review 6.2.3) in closed form: circles turn as a whole, each by its own angle, so that the material
/// between them shears.
#pragma once
#include <cmath>
#include <numbers>

#include "lab/math.hpp"

namespace mpm {

/// x = Q(alpha) X with alpha = g(t) h(R), R = |X| (6.13 to 6.16), of a neo-Hookean solid in plane strain. Beyond the ring h goes on as the
/// same polynomial: the nodes around it ask for it.
struct VortexMotion {
    double R_i = 0.75, R_o = 1.25;                       // inner and outer radius [length]
    double G = 1, T0 = 1;                                // largest angle [-], twice the time to it [time]
    double E = 1e3, nu = 0.3, rho = 1000;                // Young's modulus [stress], Poisson's ratio [-], density

    double lambda() const { return E * nu / ((1 + nu) * (1 - 2 * nu)); }
    double mu() const { return E / (2 * (1 + nu)); }
    double middle() const { return (R_i + R_o) / 2; }
    double width() const { return R_o - R_i; }
    double omega() const { return std::numbers::pi / T0; }
    double period() const { return 2 * T0; }

    /// g(t) and its first and second derivative; h(R) = (1 - 4 s^2)^2 with s = (R - middle)/width, and its derivatives.
    double g(double t) const { return G * std::sin(omega() * t); }
    double g1(double t) const { return omega() * G * std::cos(omega() * t); }
    double g2(double t) const { return -omega() * omega() * g(t); }
    double h(double R) const { return square(1 - 4 * square((R - middle()) / width())); }
    double h1(double R) const {
        const double s = (R - middle()) / width();
        return 16 * s * (4 * s * s - 1) / width();
    }
    double h2(double R) const { return (192 * square((R - middle()) / width()) - 16) / square(width()); }

    double angle(double R, double t) const { return g(t) * h(R); }
    Vec<2> x(const Vec<2>& X, double t) const { return rotation(angle(X.norm(), t)) * X; }
    Vec<2> u(const Vec<2>& X, double t) const { return x(X, t) - X; }
    Vec<2> X_of(const Vec<2>& x, double t) const { return rotation(-angle(x.norm(), t)) * x; }
    /// Not zero at the start, as printed after (6.18), but pi G/T0 h(R) R along the circle.
    Vec<2> v(const Vec<2>& X, double t) const {
        const Vec<2> now = x(X, t);
        return g1(t) * h(X.norm()) * Vec<2>(-now[1], now[0]);
    }
    /// F = Q (I + R alpha' e_Theta (x) e_R): simple shear along the circles, det F = 1.
    Mat<2> F(const Vec<2>& X, double t) const {
        const double R = X.norm();
        const Vec<2> e_R = radial(X, R), e_Theta(-e_R[1], e_R[0]);
        return rotation(angle(R, t)) * (identity<2>() + R * g(t) * h1(R) * e_Theta * e_R.transpose());
    }
    /// The largest shear R |alpha'| of the motion; |h'| is largest at s^2 = 1/12, on the outer side where R counts more.
    double largest_shear() const {
        const double R = middle() + width() / std::sqrt(12.0);
        return G * R * std::abs(h1(R));
    }

    /// Body force per mass. With P = mu R alpha' (q_Theta (x) e_R + q_R (x) e_Theta), q = Q e, the balance rho a = Div P + rho b gives
    ///   b = [R alpha_tt - (mu/rho)(3 alpha' + R alpha'')] q_Theta + [(mu/rho) R alpha'^2 - R alpha_t^2] q_R.
    /// These are (6.17) and (6.18) but for one sign: the last bracket of b_Theta there must read (mu/rho) R (g h')^2 - R (g' h)^2.
    Vec<2> b(const Vec<2>& X, double t) const {
        const double R = X.norm(), h_R = h(R), g_t = g(t), slope = g_t * h1(R), rate = g1(t) * h_R, c2 = mu() / rho;
        const double along = R * g2(t) * h_R - c2 * (3 * slope + R * g_t * h2(R)), outward = R * (c2 * slope * slope - rate * rate);
        const Vec<2> q_R = rotation(g_t * h_R) * radial(X, R);
        return outward * q_R + along * Vec<2>(-q_R[1], q_R[0]);
    }

    static Mat<2> rotation(double a) {
        Mat<2> Q;
        Q << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
        return Q;
    }

private:
    /// e_R; at the centre, a node of the grid, any direction will do.
    static Vec<2> radial(const Vec<2>& X, double R) { return R > 0 ? Vec<2>(X / R) : Vec<2>(1, 0); }
    static double square(double a) { return a * a; }
};

}  // namespace mpm
