/// The steps of implicit MPM, in the source's order; see implicit.hpp.
#pragma once
#include "chapters/implicit/implicit.hpp"

namespace mpm {

template <class Element, class Body, class Scene> bool ImplicitMpm<Element, Body, Scene>::advance(double t, double dt, int cuts) {
    const Equations solve = equations(t, dt);
    std::vector<double> u(static_cast<std::size_t>(system_.unknowns()), 0);
    NewtonResult result = newton(solve, settings_.newton, u);                  // 29 to 31
    ++counts_.solutions;
    counts_.iterations += std::max(0, result.iterations());
    counts_.most_iterations = std::max(counts_.most_iterations, result.iterations());
    counts_.unknowns = std::max(counts_.unknowns, system_.unknowns());
    if (keeps_history_) history_.push_back({t, dt, result});
    if (result.converged) {
        if (finish(u)) return true;
        result.why = "a particle is turned inside out or a projection is singular";
    }
    if (cuts == settings_.cuts) {
        trouble_ = {"unsolvable-step",
                    "at t = " + std::to_string(t) + " no solution after " + std::to_string(cuts) + " halvings of the step: " + result.why};
        return false;
    }
    ++counts_.cuts;
    return advance(t, dt / 2, cuts + 1) && advance(t + dt / 2, dt / 2, cuts + 1);
}

/// Numbers the unknowns of the active grid, and gathers what does not change while the step is solved.
template <class Element, class Body, class Scene> void ImplicitMpm<Element, Body, Scene>::prepare(double t) {
    active_.sort(grid_, body_.points);
    number_.assign(static_cast<std::size_t>(grid_.size() * D), -1);
    int count = 0;
    for (std::size_t i = 0; i < number_.size(); ++i)
        if (!held_[i] && (settings_.solve_inactive || active_.node_is_active[i / D])) number_[i] = count++;
    unknowns_.clear();
    soft_.clear();
    inactive_.clear();
    loads_.clear();
    for (std::size_t a = 0; a < active_.elements.size(); ++a) {
        auto& element = unknowns_.emplace_back();
        for (int k = 0; k < N; ++k)
            for (int d = 0; d < D; ++d) element.push_back(unknown(grid_.node(active_.elements[a], k), d));
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
            const int e = grid_.element_at(body_.points[particle].x);
            const auto a = std::lower_bound(active_.elements.begin(), active_.elements.end(), e) - active_.elements.begin();
            const auto w = element_weights<Element, D>(grid_, e, x);
            Vector load;
            for (int k = 0; k < N; ++k) load.template segment<D>(k * D) = w.phi[static_cast<std::size_t>(k)] * force;
            loads_.emplace_back(static_cast<std::size_t>(a), load);
        }
    counts_.solution.start();
    system_.use(count, unknowns_);
    counts_.solution.stop();
}

/// (28): r of the particles, the soft stiffness, tractions, and inactive nodes.
template <class Element, class Body, class Scene>
bool ImplicitMpm<Element, Body, Scene>::residual(const std::vector<double>& u, std::vector<double>& r, double& terms, double& rounding) {
    constexpr double eps = 2.3e-16;  // F near 1 is known to this, so stresses to E eps
    counts_.assembly.start();
    const std::size_t elements = active_.elements.size();
    std::vector<Vector> part(elements, Vector::Zero()), size = part, floor = part;
    std::vector<char> well(elements, 1);
    in_ranges(settings_.threads, elements, [&](std::size_t a) __attribute__((noinline)) {  // too much to be inlined in its loop
        const Vector u_e = of_element(a, u);
        well[a] = each_particle(a, [&](std::size_t, const auto& p, const auto& w) {
            Vector one = Vector::Zero();
            if (!add_residual<double, D, N>(p, law(p), w, u_e, now_, one)) return false;
            const Vec<D> known = p.m * (now_.newmark.known(p, now_.dt).cwiseAbs() + now_.b.cwiseAbs());
            const double modulus = 4 * eps * p.V0 * (law(p).lambda + 2 * law(p).mu);
            for (int k = 0; k < N; ++k)
                for (int d = 0; d < D; ++d) {
                    size[a][k * D + d] += std::abs(one[k * D + d]) + known[d] * std::abs(w.phi[static_cast<std::size_t>(k)]);
                    floor[a][k * D + d] += modulus * w.grad[static_cast<std::size_t>(k)].template lpNorm<1>();
                }
            part[a] += one;
            return true;
        });
        if (!soft_.empty()) part[a] += soft_[a] * u_e;                          // 26
    });
    for (const auto& [a, load] : loads_) part[a] -= load, size[a] += load.cwiseAbs();
    std::vector<double> s(r.size(), 0), e(r.size(), 0);
    std::fill(r.begin(), r.end(), 0.0);
    reaction_ = Vec<D>::Zero();
    for (std::size_t a = 0; a < elements; ++a)
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
        const auto at = static_cast<std::size_t>(unknowns_[elements + k][0]);
        r[at] += inactive_[k] * u[at];
    }
    const auto norm = [](const std::vector<double>& x) {
        return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())).norm();
    };
    terms = norm(s), rounding = norm(e);
    counts_.assembly.stop();
    return std::find(well.begin(), well.end(), 0) == well.end();
}

template <class Element, class Body, class Scene> void ImplicitMpm<Element, Body, Scene>::assemble_tangent(const std::vector<double>& u) {
    counts_.assembly.start();
    std::vector<Matrix> K(active_.elements.size());
    in_ranges(settings_.threads, K.size(), [&](std::size_t a) __attribute__((noinline)) {
        const Vector u_e = of_element(a, u);
        K[a] = soft_.empty() ? Matrix(Matrix::Zero()) : soft_[a];
        each_particle(a, [&](std::size_t, const auto& p, const auto& w) {
            if (settings_.automatic) add_ad_tangent<D, N>(p, law(p), w, u_e, now_, K[a]);
            else add_tangent<D, N>(p, law(p), w, u_e, now_, K[a]);
            return true;
        });
    });
    system_.clear();
    for (std::size_t a = 0; a < K.size(); ++a) system_.add(static_cast<int>(a), K[a].data());
    for (std::size_t k = 0; k < inactive_.size(); ++k) system_.add(static_cast<int>(K.size() + k), &inactive_[k]);
    counts_.assembly.stop();
}

template <class Element, class Body, class Scene>
bool ImplicitMpm<Element, Body, Scene>::direction(const std::vector<double>& u, const std::vector<double>& r, std::vector<double>& du) {
    assemble_tangent(u);
    std::vector<double> minus_r(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) minus_r[i] = -r[i];
    counts_.solution.start();
    const bool well = system_.solve(minus_r, du);                               // 31, 32
    counts_.solution.stop();
    return well;
}

/// (34), (35), (17), (19): moves the particles. False, with nothing changed, where one would be turned inside out.
template <class Element, class Body, class Scene> bool ImplicitMpm<Element, Body, Scene>::finish(const std::vector<double>& u) {
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
        if (!well) return false;
        if (!soft_.empty()) soft_work += u_e.dot(soft_[a] * u_e);
    }
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
    for (int d = 0; d < D; ++d)  // v gets (1 - gamma) of the old and gamma of the new accelerations, whose sums are these forces
        supply_.impulse[static_cast<std::size_t>(d)] += dt * ((1 - gamma) * force_[d] + gamma * force[d]);
    force_ = force;
    return true;
}

}  // namespace mpm
