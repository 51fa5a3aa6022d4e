/// The steps of implicit MPM, in the source's order; see implicit.hpp.
#pragma once
#include "chapters/implicit/implicit.hpp"

namespace mpm {

template <class Element, class Body, class Scene, class Attached>
bool ImplicitMpm<Element, Body, Scene, Attached>::advance(double t, double dt, int cuts) {
    const Equations solve = equations(t, dt);
    turned_ = 0;
    std::vector<double> u(static_cast<std::size_t>(solver().unknowns()), 0);
    NewtonResult result = newton(solve, settings_.newton, u);                  // 29 to 31
    ++counts_.solutions;
    counts_.iterations += std::max(0, result.iterations());
    counts_.most_iterations = std::max(counts_.most_iterations, result.iterations());
    counts_.unknowns = std::max(counts_.unknowns, solver().unknowns());
    counts_.nonzeros = solver().nonzeros();
    counts_.analyses = symmetric_system_.analyses() + any_system_.analyses();
    counts_.factorisations = symmetric_system_.factorisations() + any_system_.factorisations();
    if (keeps_history_) history_.push_back({t, dt, result});
    if (result.converged) {
        if (finish(u)) return !(trouble_ = attached_.trouble());
        result.why = "a particle is turned inside out or a projection is singular";
    }
    if (cuts == settings_.cuts) {
        if (turned_ == 'e') result.why += "; an element of the finite element body would be turned inside out";
        trouble_ = {turned_ == 'e' ? "inverted-element" : "unsolvable-step",
                    "at t = " + std::to_string(t) + " no solution after " + std::to_string(cuts) + " halvings of the step: " + result.why};
        return false;
    }
    ++counts_.cuts;
    return advance(t, dt / 2, cuts + 1) && advance(t + dt / 2, dt / 2, cuts + 1);
}

/// Numbers the unknowns of the active grid, and gathers what does not change while the step is solved.
template <class Element, class Body, class Scene, class Attached> void ImplicitMpm<Element, Body, Scene, Attached>::prepare(double t) {
    if constexpr (Attached::any) attached_.begin(now_, scene_, t);
    const auto element_of = [&](std::size_t i) { return attached_.element(grid_, i, body_.points[i]); };
    active_.sort(grid_, body_.points, element_of, attached_.elements());
    general_ = settings_.carry == Carry::conserving || any_recedes();
    number_.assign(static_cast<std::size_t>(grid_.size() * D), -1);
    int count = 0;
    for (std::size_t i = 0; i < number_.size(); ++i)
        if (!held_[i] && (settings_.solve_inactive || active_.node_is_active[i / D])) number_[i] = count++;
    unknowns_.clear();
    soft_.clear();
    inactive_.clear();
    loads_.clear();
    for (std::size_t a = 0; a < elements(); ++a) {
        auto& numbers = unknowns_.emplace_back();
        for (int k = 0; k < N; ++k)
            for (int d = 0; d < D; ++d) numbers.push_back(unknown(grid_.node(element(a), k), d));
        if (a >= active_.elements.size()) continue;
        if (settings_.soft.few > 0 || settings_.soft.some > 0) {
            const double C = settings_.soft.of(active_.flags[a], N), mu = law(body_.points[active_.particles[active_.begin[a]]]).mu;
            soft_.push_back(C > 0 ? Matrix(mu * C * soft_matrix<Element>(grid_, active_.elements[a])) : Matrix(Matrix::Zero()));
        }
    }
    if (settings_.solve_inactive) {                                             // 27
        std::vector<double> volume(static_cast<std::size_t>(grid_.size()), 0);
        for (int e = 0; e < grid_.elements(); ++e)
            each_gauss_point<Element>(grid_, e, [&](const auto& w, double V) {
                for (int k = 0; k < N; ++k) volume[static_cast<std::size_t>(grid_.node(e, k))] += V * w.phi[static_cast<std::size_t>(k)];
            });
        for (std::size_t i = 0; i < number_.size(); ++i)
            if (number_[i] >= 0 && !active_.node_is_active[i / D]) unknowns_.push_back({number_[i]}), inactive_.push_back(volume[i / D]);
    }
    if constexpr (requires { scene_.tractions(body_.points, t); })
        for (const auto& [particle, x, force] : scene_.tractions(body_.points, t)) {
            const int e = element_of(particle);
            const auto a = std::lower_bound(active_.elements.begin(), active_.elements.end(), e) - active_.elements.begin();
            const auto w = element_weights<Element, D>(grid_, e, x);
            Vector load;
            for (int k = 0; k < N; ++k) load.template segment<D>(k * D) = w.phi[static_cast<std::size_t>(k)] * force;
            loads_.emplace_back(static_cast<std::size_t>(a), load);
        }
    counts_.solution.start();
    solver().use(count, unknowns_);
    counts_.solution.stop();
}

template <class Element, class Body, class Scene, class Attached> bool ImplicitMpm<Element, Body, Scene, Attached>::any_recedes() const {
    for (std::size_t a = 0; a < active_.elements.size(); ++a)
        if (const int e = active_.elements[a]; settings_.receding.on_face<Element>(grid_, e))
            for (std::size_t i = active_.begin[a]; i < active_.begin[a + 1]; ++i)
                if (const auto p = active_.particles[i]; attached_.recedes(settings_.receding, grid_, e, p, body_.points[p])) return true;
    return false;
}

/// (28): r of the particles, the soft stiffness, tractions, and inactive nodes.
template <class Element, class Body, class Scene, class Attached>
bool ImplicitMpm<Element, Body, Scene, Attached>::residual(const std::vector<double>& u, std::vector<double>& r, double& terms,
                                                             double& rounding) {
    constexpr double eps = 2.3e-16;  // F near 1 is known to this, so stresses to E eps
    counts_.assembly.start();
    const std::size_t count = elements();
    std::vector<Vector> part(count, Vector::Zero()), size = part, floor = part;
    std::vector<char> well(count, 1);
    in_ranges(settings_.threads, count, [&](std::size_t a) __attribute__((noinline)) {  // too much to be inlined in its loop
        const Vector u_e = of_element(a, u);
        well[a] = each_point(a, [&](const auto& p, const NeoHookean& material, const auto& w, const StepOf<D>& step) {
            Vector one = Vector::Zero();
            if (!add_residual<double, D, N>(p, material, w, u_e, step, one)) return false;
            const Vec<D> known = p.m * (step.newmark.known(p, step.dt).cwiseAbs() + step.b.cwiseAbs());
            const double modulus = 4 * eps * p.V0 * (material.lambda + 2 * material.mu);
            for (int k = 0; k < N; ++k)
                for (int d = 0; d < D; ++d) {
                    size[a][k * D + d] += std::abs(one[k * D + d]) + known[d] * std::abs(w.phi[static_cast<std::size_t>(k)]);
                    floor[a][k * D + d] += modulus * w.grad[static_cast<std::size_t>(k)].template lpNorm<1>();
                }
            part[a] += one;
            return true;
        });
        if (a < soft_.size()) part[a] += soft_[a] * u_e;                        // 26
    });
    for (const auto& [a, load] : loads_) part[a] -= load, size[a] += load.cwiseAbs();
    std::vector<double> s(r.size(), 0), e(r.size(), 0);
    std::fill(r.begin(), r.end(), 0.0);
    reaction_ = Vec<D>::Zero();
    for (std::size_t a = 0; a < count; ++a)
        for (int i = 0; i < N * D; ++i) {
            const int number = unknowns_[a][static_cast<std::size_t>(i)];
            if (number < 0) {
                reaction_[i % D] += part[a][i];
                continue;
            }
            const auto at = static_cast<std::size_t>(number);
            r[at] += part[a][i], s[at] += size[a][i], e[at] += floor[a][i];
        }
    for (std::size_t k = 0; k < inactive_.size(); ++k) {
        const auto at = static_cast<std::size_t>(unknowns_[count + k][0]);
        r[at] += inactive_[k] * u[at];
    }
    const auto norm = [](const std::vector<double>& x) {
        return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())).norm();
    };
    terms = norm(s), rounding = norm(e);
    part_.swap(part);
    const std::ptrdiff_t first = std::find(well.begin(), well.end(), 0) - well.begin();
    if (first < std::ssize(well)) turned_ = first < std::ssize(active_.elements) ? 'p' : 'e';
    counts_.assembly.stop();
    return first == std::ssize(well);
}

template <class Element, class Body, class Scene, class Attached>
std::vector<double> ImplicitMpm<Element, Body, Scene, Attached>::residual_of(bool attached) const {
    std::vector<double> r(static_cast<std::size_t>(grid_.size() * D), 0);
    for (std::size_t a = attached ? active_.elements.size() : 0; a < (attached ? elements() : active_.elements.size()); ++a)
        for (int i = 0; i < N * D; ++i) r[static_cast<std::size_t>(grid_.node(element(a), i / D) * D + i % D)] += part_[a][i];
    return r;
}

template <class Element, class Body, class Scene, class Attached>
void ImplicitMpm<Element, Body, Scene, Attached>::assemble_tangent(const std::vector<double>& u) {
    counts_.assembly.start();
    std::vector<Matrix> K(elements());
    in_ranges(settings_.threads, K.size(), [&](std::size_t a) __attribute__((noinline)) {
        const Vector u_e = of_element(a, u);
        K[a] = a < soft_.size() ? soft_[a] : Matrix(Matrix::Zero());
        each_point(a, [&](const auto& p, const NeoHookean& material, const auto& w, const StepOf<D>& step) {
            if (settings_.automatic) add_ad_tangent<D, N>(p, material, w, u_e, step, K[a]);
            else add_tangent<D, N>(p, material, w, u_e, step, K[a]);
            return true;
        });
    });
    solver().clear();
    for (std::size_t a = 0; a < K.size(); ++a) solver().add(static_cast<int>(a), K[a].data());
    for (std::size_t k = 0; k < inactive_.size(); ++k) solver().add(static_cast<int>(K.size() + k), &inactive_[k]);
    counts_.assembly.stop();
}

template <class Element, class Body, class Scene, class Attached>
bool ImplicitMpm<Element, Body, Scene, Attached>::direction(const std::vector<double>& u, const std::vector<double>& r,
                                                              std::vector<double>& du) {
    assemble_tangent(u);
    std::vector<double> minus_r(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) minus_r[i] = -r[i];
    counts_.solution.start();
    const bool well = solver().solve(minus_r, du);                               // 31, 32
    counts_.solution.stop();
    return well;
}

/// (34), (35), (17), (19): moves the particles. False, with nothing changed, where one would be turned inside out.
template <class Element, class Body, class Scene, class Attached>
bool ImplicitMpm<Element, Body, Scene, Attached>::finish(const std::vector<double>& u) {
    auto& points = body_.points;
    std::vector<Vec<D>> moved(points.size(), Vec<D>::Zero());
    std::vector<Mat<D>> f(points.size(), identity<D>());
    double soft_work = 0;
    for (std::size_t a = 0; a < active_.elements.size(); ++a) {
        const Vector u_e = of_element(a, u);
        const bool well = each_particle(a, [&](std::size_t i, const auto&, const auto& w) {
            for (int k = 0; k < N; ++k) {
                const Vec<D> u_k = u_e.template segment<D>(k * D);
                moved[i] += w.phi[static_cast<std::size_t>(k)] * u_k;            // 35
                f[i] += u_k * w.trial[static_cast<std::size_t>(k)].transpose();
            }
            return f[i].determinant() > 0;
        });
        if (!well) return turned_ = 'p', false;
        if (a < soft_.size()) soft_work += u_e.dot(soft_[a] * u_e);
    }
    if constexpr (Attached::any)
        if (!attached_.accepts(grid_, u, number_)) return turned_ = 'e', false;
    std::vector<Vec<D>> seen;  // what the grid sees of a field of the particles
    if (settings_.carry == Carry::lumped || settings_.carry == Carry::projected || settings_.carry == Carry::increment) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (by_midpoint(settings_.carry)) seen.push_back(points[i].v);
            else seen.push_back(now_.newmark.inertia(now_.dt) * moved[i] - now_.newmark.known(points[i], now_.dt));
        if (!Projection<Element, D>(grid_, active_).apply(points, settings_.carry == Carry::lumped, seen)) return false;
    }
    counts_.soft_work += soft_work;
    Vec<D> force = reaction_;
    const double dt = now_.dt, gamma = now_.newmark.gamma;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto& p = points[i];
        p.F = f[i] * p.F;                                                        // 34
        p.V = p.V0 * p.F.determinant();
        body_.law.update(p, p.F, dt);
        p.x += moved[i];
        if (settings_.carry == Carry::increment) {
            p.v += 2 * (moved[i] / dt - seen[i]);
        } else if (!seen.empty()) {
            p.v += dt * ((1 - gamma) * p.a + gamma * seen[i]);
            p.a = seen[i];
        } else {
            now_.newmark.finish(p, moved[i], dt);                                // 17, 19
        }
        force += p.m * now_.b;
        supply_.work += p.m * now_.b.dot(moved[i]);
    }
    for (const auto& [a, load] : loads_) {
        supply_.work += load.dot(of_element(a, u));
        for (int k = 0; k < N; ++k) force += load.template segment<D>(k * D);
    }
    if constexpr (Attached::any) {
        attached_.exchange(residual_of(false), residual_of(true), number_);
        supply_.work += attached_.move(grid_, u, number_, body_.points);
        force += attached_.force();
    }
    for (int d = 0; d < D; ++d)  // v gets (1 - gamma) of the old and gamma of the new accelerations, whose sums are these forces
        supply_.impulse[static_cast<std::size_t>(d)] += dt * ((1 - gamma) * force_[d] + gamma * force[d]);
    force_ = force;
    return true;
}

}  // namespace mpm
