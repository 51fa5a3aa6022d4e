/// Newton's method with a line search for nonlinear equations r(u) = 0 (Aulisa and Capodaglio, equations 29 to 31), and its history.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace mpm {

/// What is solved. Vectors hold one value for each unknown.
struct Equations {
    /// Writes r(u) and the size of what it is made of: |r| <= tolerance |terms| + |rounding| is as good as zero. False where r is not
    /// defined (an element or a particle turned inside out).
    std::function<bool(const std::vector<double>& u, std::vector<double>& r, double& terms, double& rounding)> residual;
    /// Writes the solution of K(u) du = -r. False if K is singular.
    std::function<bool(const std::vector<double>& u, const std::vector<double>& r, std::vector<double>& du)> direction;
};

struct NewtonSettings {
    double tolerance = 1e-10;  // of |r| over the size of its terms [-]
    int iterations = 30;       // at most
    int halvings = 12;         // of a Newton step in the line search, at most
};

/// One iteration: |r| and the size of its terms before it, the part of the Newton step that was taken.
struct NewtonRecord {
    double residual, terms, part;
};

struct NewtonResult {
    bool converged = false;
    std::string why = {};  // it did not
    std::vector<NewtonRecord> history = {};
    int iterations() const { return static_cast<int>(history.size()) - 1; }
};

/// Solves from the u that it is given, which holds the solution afterwards.
NewtonResult newton(const Equations& equations, const NewtonSettings& settings, std::vector<double>& u);

}  // namespace mpm
