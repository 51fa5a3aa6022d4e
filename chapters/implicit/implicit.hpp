/// Implicit MPM (Aulisa and Capodaglio, "Monolithic coupling of implicit material point method with finite element method", 3.3): particles
/// are the quadrature points of a finite element grid that is reset after every step, Newmark's rule acts at the particles, and Newton's
/// method solves for the displacements of the active grid. There is no mapping from particles to nodes.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "chapters/implicit/active.hpp"
#include "chapters/implicit/alone.hpp"
#include "chapters/implicit/carry.hpp"
#include "chapters/implicit/newton.hpp"
#include "chapters/implicit/receding.hpp"
#include "chapters/implicit/residual.hpp"
#include "lab/clock.hpp"
#include "lab/monitor.hpp"
#include "lab/sparse_system.hpp"
#include "lab/threads.hpp"

namespace mpm {

struct ImplicitSettings {
    Newmark newmark = {};
    NewtonSettings newton = {};
    SoftTable soft = {};
    RecedingContact receding = {};
    Carry carry = Carry::particle;
    bool automatic = false;       // tangent by automatic differentiation
    bool solve_inactive = false;  // inactive nodes are solved for (27) rather than left out: the same result
    int cuts = 8;                 // halvings of a step that cannot be solved, at most
    int threads = 1;
};

/// One Newton solution and when it was.
struct SolvedStep {
    double t, dt;
    NewtonResult newton;
};

/// What a method tells of itself.
struct ImplicitCounts {
    long solutions = 0, iterations = 0, cuts = 0;
    int most_iterations = 0, unknowns = 0;
    long nonzeros = 0, analyses = 0, factorisations = 0;  // of the last tangent; symbolic and numerical factorisations
    double soft_work = 0;                 // energy that the soft stiffness took
    Stopwatch assembly = {}, solution = {};
};

/// `Body` is a Matter of ImplicitPoints; the scene tells held(grid), for each component of each node whether it is held at zero;
/// body_force(t), per mass; and, if it has any, tractions(points, t): forces {particle, x, force} that act in the particle's element.
/// `Attached` says how the grid is deformed at the start of a step, and may add elements with quadrature points of their own.
template <class Element, class Body, class Scene, class Attached = Alone<Element, Body>> class ImplicitMpm {
public:
    static constexpr int D = Body::D, N = power(Element::count, D);
    using Vector = ElementVector<double, D, N>;
    using Matrix = ElementMatrix<D, N>;

    ImplicitMpm(const ImplicitSettings& settings, const Rectilinear<D>& grid, Body& body, const Scene& scene)
        : settings_(settings), grid_(grid), body_(body), scene_(scene), held_(scene.held(grid)) {
        if constexpr (Attached::any) attached_.attach(grid_, scene_, held_, body_.points);
    }

    /// One step; if it cannot be solved, in halves. Trouble is kept, and then the particles are as good as they were at last.
    void step(double t, double dt) {
        supply_ = {};
        advance(t, dt, 0);
    }
    const Trouble& trouble() const { return trouble_; }
    const Supply& supply() const { return supply_; }
    const ImplicitCounts& counts() const { return counts_; }
    const std::vector<SolvedStep>& history() const { return history_; }
    void keep_history(bool keep) { keeps_history_ = keep; }
    const SparseSystem& system() const { return general_ ? any_system_ : symmetric_system_; }
    Attached& attached() { return attached_; }
    const Attached& attached() const { return attached_; }
    const ActiveGrid<D>& active() const { return active_; }
    const Rectilinear<D>& grid() const { return grid_; }

    /// The equations of a step from t, for those who look at them: tests, and bodies of other kinds that share the grid.
    Equations equations(double t, double dt) {
        now_ = {settings_.newmark, dt, scene_.body_force(t + settings_.newmark.theta * dt), settings_.carry == Carry::conserving};
        prepare(t);
        return {[this](const auto& u, auto& r, double& terms, double& rounding) { return residual(u, r, terms, rounding); },
                [this](const auto& u, const auto& r, auto& du) { return direction(u, r, du); }};
    }
    void assemble_tangent(const std::vector<double>& u);
    /// What the particles, or the attached elements, gave to the last residual at each component of each node, held ones included.
    std::vector<double> residual_of(bool attached) const;
    int unknown(int node, int d) const { return number_[static_cast<std::size_t>(node * D + d)]; }

private:
    bool advance(double t, double dt, int cuts);
    void prepare(double t);
    bool residual(const std::vector<double>& u, std::vector<double>& r, double& terms, double& rounding);
    bool direction(const std::vector<double>& u, const std::vector<double>& r, std::vector<double>& du);
    bool finish(const std::vector<double>& u);

    const NeoHookean& law(const typename Body::Point& p) const {
        if constexpr (requires { body_.law.law(p); }) return body_.law.law(p);
        else return body_.law;
    }
    template <class Visit> bool each_particle(std::size_t a, Visit&& visit) const {
        const int e = active_.elements[a];
        for (std::size_t i = active_.begin[a]; i < active_.begin[a + 1]; ++i) {
            const auto& p = body_.points[active_.particles[i]];
            auto w = attached_.weights(grid_, e, active_.particles[i], p);
            if (attached_.recedes(settings_.receding, grid_, e, active_.particles[i], p)) settings_.receding.follow<Element>(w);
            if (!visit(active_.particles[i], p, w)) return false;
        }
        return true;
    }
    /// Active elements come first, attached ones behind them.
    std::size_t elements() const { return active_.elements.size() + attached_.elements().size(); }
    int element(std::size_t a) const {
        const std::size_t active = active_.elements.size();
        return a < active ? active_.elements[a] : attached_.elements()[a - active];
    }
    /// Visits what an element is integrated by, (point, law, weights, step).
    template <class Visit> bool each_point(std::size_t a, Visit&& visit) const {
        if constexpr (Attached::any)
            if (a >= active_.elements.size()) return attached_.each_point(grid_, a - active_.elements.size(), visit);
        return each_particle(a, [&](std::size_t, const auto& p, const auto& w) { return visit(p, law(p), w, now_); });
    }
    bool any_recedes() const;
    SparseSystem& solver() { return general_ ? any_system_ : symmetric_system_; }
    Vector of_element(std::size_t a, const std::vector<double>& u) const {
        Vector part;
        for (int i = 0; i < N * D; ++i) {
            const int number = unknowns_[a][static_cast<std::size_t>(i)];
            part[i] = number < 0 ? 0 : u[static_cast<std::size_t>(number)];
        }
        return part;
    }

    ImplicitSettings settings_;
    Rectilinear<D> grid_;
    Body& body_;
    const Scene& scene_;
    std::vector<char> held_;
    Attached attached_{};
    SparseSystem symmetric_system_{true}, any_system_{false};
    bool general_ = false;                             // the tangent of this step is not symmetric
    ActiveGrid<D> active_;
    StepOf<D> now_{};
    std::vector<int> number_;                          // unknown of each component of each node, -1 for none
    std::vector<Vector> part_;                         // of the last residual, of each element
    char turned_ = 0;                                  // what it would have turned inside out: 'p', a particle, 'e', an attached element
    std::vector<std::vector<int>> unknowns_;           // of each active and attached element, then of each inactive node that is solved for
    std::vector<Matrix> soft_;                         // of each active element; empty if there is none
    std::vector<double> inactive_;                     // the lumped volume of each inactive node that is solved for
    std::vector<std::pair<std::size_t, Vector>> loads_;  // tractions, by active element
    Vec<D> reaction_ = Vec<D>::Zero(), force_ = Vec<D>::Zero();  // of held nodes; all that acts from outside, at the end of the last step
    Supply supply_;
    Trouble trouble_;
    ImplicitCounts counts_;
    bool keeps_history_ = false;
    std::vector<SolvedStep> history_;
};

}  // namespace mpm

#include "chapters/implicit/implicit_steps.hpp"
