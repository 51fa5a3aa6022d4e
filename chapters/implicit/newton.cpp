#include "chapters/implicit/newton.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

#include "lab/record.hpp"

namespace mpm {
namespace {

double norm(const std::vector<double>& x) { return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0)); }

/// A place on the way: unknowns, residual, and what it is measured by.
struct Place {
    std::vector<double> u, r;
    double residual = 0, terms = 0, rounding = 0;
    bool find(const Equations& equations) {
        if (!equations.residual(u, r, terms, rounding)) return false;
        residual = norm(r);
        return std::isfinite(residual);
    }
    bool solves(double tolerance) const { return residual <= tolerance * terms + rounding; }
};

}  // namespace

NewtonResult newton(const Equations& equations, const NewtonSettings& settings, std::vector<double>& u) {
    constexpr double enough = 1e-4;  // of the decrease that the linear model promises (Armijo)
    NewtonResult result;
    Place now{u, std::vector<double>(u.size())}, next = now;
    if (!now.find(equations)) return result.why = "the residual is not a number at the start", result;
    std::vector<double> du(u.size());
    while (true) {
        result.history.push_back({now.residual, now.terms, 1});
        if (now.solves(settings.tolerance)) {
            result.converged = true;
            u = now.u;
            return result;
        }
        if (result.iterations() == settings.iterations)
            return result.why = "Newton has not converged in " + std::to_string(settings.iterations) + " iterations, |r| = " +
                                number_text(now.residual) + ", its terms " + number_text(now.terms),
                   result;
        if (!equations.direction(now.u, now.r, du)) return result.why = "the tangent is singular", result;
        double part = 1;
        for (int k = 0; k <= settings.halvings; ++k, part /= 2) {
            for (std::size_t i = 0; i < u.size(); ++i) next.u[i] = now.u[i] + part * du[i];
            if (next.find(equations) && (next.residual <= (1 - enough * part) * now.residual || next.solves(settings.tolerance))) break;
            if (k == settings.halvings) return result.why = "no part of Newton's step makes the residual smaller", result;
        }
        result.history.back().part = part;
        std::swap(now, next);
    }
}

}  // namespace mpm
