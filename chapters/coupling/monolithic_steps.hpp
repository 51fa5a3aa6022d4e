/// The steps of the finite element body; see monolithic.hpp.
#pragma once
#include <algorithm>

#include "chapters/coupling/monolithic.hpp"

namespace mpm {

template <class Element, class Body> template <class Scene>
void FemBody<Element, Body>::attach(const Rectilinear<D>& grid, const Scene& scene, const std::vector<char>& held,
                                    const std::vector<Point>& particles) {
    elements_ = scene.fem_elements(grid);
    gauss_.law = scene.fem_law();
    is_body_.assign(static_cast<std::size_t>(grid.elements()), 0);
    is_body_node_.assign(static_cast<std::size_t>(grid.size()), 0);
    nodes_.assign(static_cast<std::size_t>(grid.size()), NodeState{});
    for (const int e : elements_) {
        is_body_[static_cast<std::size_t>(e)] = 1;
        for (int k = 0; k < N; ++k) is_body_node_[static_cast<std::size_t>(grid.node(e, k))] = 1;
        each_gauss_point<Element>(grid, e, [&](const auto& w, double volume) {
            Point& p = gauss_.points.emplace_back();
            for (int k = 0; k < N; ++k) p.X += w.phi[static_cast<std::size_t>(k)] * grid.position(grid.node(e, k));
            p.V0 = volume;
            if constexpr (requires { p.material = scene.fem_material(p.X); }) p.material = scene.fem_material(p.X);
            p.m = law(p).rho * volume;
            mass_ += p.m;
        });
    }
    if constexpr (requires(NodeState& node) { scene.fem_start(Vec<D>(), node); })
        for (int I = 0; I < grid.size(); ++I)
            if (is_body_node(I)) scene.fem_start(grid.position(I), nodes_[static_cast<std::size_t>(I)]);
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i]) {
            const auto d = static_cast<Eigen::Index>(i % D);
            nodes_[i / D].u[d] = nodes_[i / D].v[d] = nodes_[i / D].a[d] = 0;
        }
    std::vector<int> background;
    for (int e = 0; e < grid.elements(); ++e)
        if (!is_body_[static_cast<std::size_t>(e)]) background.push_back(e);
    extension_.use(grid, background, is_body_node_, scene.reset_held(grid));
    refresh(grid);
    reset(grid);
    places_.clear();
    for (const Point& p : particles) places_.push_back({0, p.x});
    find(grid, particles);
    keep();
}

/// (39), (43): what the Gauss points have from the nodes.
template <class Element, class Body> void FemBody<Element, Body>::refresh(const Rectilinear<D>& grid) {
    for (std::size_t q = 0; q < gauss_.points.size(); ++q) {
        Point& p = gauss_.points[q];
        const int e = elements_[q / N];
        const auto w = element_weights<Element, D>(grid, e, p.X);
        p.F = gradient(grid, e, w);
        p.V = p.V0 * p.F.determinant();
        p.x = p.X + at(grid, e, w, &NodeState::u);
        p.v = at(grid, e, w, &NodeState::v);
        p.a = at(grid, e, w, &NodeState::a);
        gauss_.law.update(p, p.F, step_.dt);
    }
}

/// (8), (9)
template <class Element, class Body> void FemBody<Element, Body>::reset(const Rectilinear<D>& grid) {
    std::vector<Vec<D>> u;
    u.reserve(nodes_.size());
    for (const NodeState& node : nodes_) u.push_back(node.u);
    if (!extension_.extend(grid, u)) trouble_ = {"singular-extension", "the background's extension of the body's displacement is singular"};
    flat_ = true;
    for (std::size_t I = 0; I < nodes_.size(); ++I) {
        nodes_[I].u = u[I];
        flat_ = flat_ && u[I].isZero(0);
    }
}

template <class Element, class Body>
bool FemBody<Element, Body>::accepts(const Rectilinear<D>& grid, const std::vector<double>& u, const std::vector<int>& number) const {
    const auto increment = [&](int I, int d) {
        const int n = number[static_cast<std::size_t>(I * D + d)];
        return n < 0 ? 0 : u[static_cast<std::size_t>(n)];
    };
    const auto well = [&](int e, const Vec<D>& X) {
        const auto w = element_weights<Element, D>(grid, e, X);
        Mat<D> F = gradient(grid, e, w);
        for (int k = 0; k < N; ++k)
            for (int d = 0; d < D; ++d) F.row(d) += increment(grid.node(e, k), d) * w.grad[static_cast<std::size_t>(k)].transpose();
        return F.determinant() > 0;
    };
    for (std::size_t a = 0; a < elements_.size(); ++a)
        for (std::size_t k = 0; k < N; ++k)
            if (!well(elements_[a], gauss_.points[a * N + k].X) ||
                !well(elements_[a], grid.position(grid.node(elements_[a], static_cast<int>(k)))))
                return false;
    return true;
}

template <class Element, class Body>
double FemBody<Element, Body>::move(const Rectilinear<D>& grid, const std::vector<double>& u, const std::vector<int>& number,
                                    const std::vector<Point>& particles) {
    for (std::size_t I = 0; I < nodes_.size(); ++I) {
        if (!is_body_node_[I]) continue;
        Vec<D> increment;
        for (int d = 0; d < D; ++d) {
            const int n = number[I * D + static_cast<std::size_t>(d)];
            increment[d] = n < 0 ? 0 : u[static_cast<std::size_t>(n)];
        }
        nodes_[I].u += increment;
        step_.newmark.finish(nodes_[I], increment, step_.dt);                   // 46
    }
    double work = 0;
    for (const Point& p : gauss_.points) work -= p.m * step_.b.dot(p.x);
    refresh(grid);
    for (const Point& p : gauss_.points) work += p.m * step_.b.dot(p.x);
    reset(grid);
    find(grid, particles);
    return work;
}

/// The face under a particle moves, and turns.
template <class Element, class Body>
bool FemBody<Element, Body>::recedes(const RecedingContact& contact, const Rectilinear<D>& grid, int element, std::size_t i,
                                     const Point& p) const {
    if (!contact.on_face<Element>(grid, element)) return false;
    Vec<D> foot = places_[i].X;
    foot[contact.axis] = grid.low(element, contact.axis);
    const auto w = element_weights<Element, D>(grid, element, foot);
    Vec<D> face_v = Vec<D>::Zero(), axis = Vec<D>::Zero();
    for (int k = 0; k < N; ++k)
        if (const int I = grid.node(element, k); is_body_node(I)) face_v += w.phi[static_cast<std::size_t>(k)] * node(I).v;
    axis[contact.axis] = 1;
    return (p.v - face_v).dot(cofactor(gradient(grid, element, w)) * axis) > 0;
}

/// Finds particles in the undeformed grid, whose displaced points X + u(X) they are.
template <class Element, class Body>
void FemBody<Element, Body>::find(const Rectilinear<D>& grid, const std::vector<Point>& particles) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
        Place& place = places_[i];
        if (!find_one(grid, particles[i].x, place)) {
            const std::string who = detail::place(i, particles[i]);
            if (!trouble_) trouble_ = {"tangled-background", who + " is in no element of the deformed background"};
        } else if (is_body_[static_cast<std::size_t>(place.element)]) {
            ++inside_;
            if (!trouble_) trouble_ = {"particle-inside-body", detail::place(i, particles[i]) + " lies in the finite element body"};
        }
    }
}
/// Newton's method for X + u(X) = x, whose map is smooth in an element and continuous between them: from the last place, X goes into
/// whatever element it comes to. Throws OutsideGrid.
template <class Element, class Body>
bool FemBody<Element, Body>::find_one(const Rectilinear<D>& grid, const Vec<D>& x, Place& place) const {
    constexpr int most = 40;
    constexpr double eps = 16 * 2.3e-16;  // of the size of the grid: rounding of x and of its sum
    if (flat_) return place = {grid.element_at(x), x}, true;
    Vec<D> X = x, low, high;
    double size = 0;
    for (int d = 0; d < D; ++d) {
        low[d] = grid.lines(d).front(), high[d] = grid.lines(d).back();
        size = std::max({size, std::abs(low[d]), std::abs(high[d])});
    }
    for (int i = 0; i < most; ++i) {
        const Vec<D> inner = X.cwiseMax(low).cwiseMin(high);
        place = {grid.element_at(inner), inner};
        const auto w = element_weights<Element, D>(grid, place.element, inner);
        const Mat<D> F = gradient(grid, place.element, w);
        const Vec<D> missing = x - inner - at(grid, place.element, w, &NodeState::u);
        if (missing.template lpNorm<Eigen::Infinity>() <= eps * size) return true;
        if (!(F.determinant() > 0)) return false;
        X = inner + cofactor(F).transpose() * missing / F.determinant();
        if (i > most / 2) X = 0.5 * (X + inner);  // between two elements that send it back and forth
    }
    grid.element_at(X);
    return false;
}

template <class Element, class Body> void FemBody<Element, Body>::add_facts(std::vector<std::pair<std::string, double>>& facts) const {
    facts.emplace_back("finite elements of the body", static_cast<double>(elements_.size()));
    facts.emplace_back("particles found inside the body", static_cast<double>(inside_));
    facts.emplace_back("unbalanced / exchanged momentum", exchange_.imbalance());
}

/// The elements as they are deformed, with eight corners, and their flags M_E: 0 without particles, -1 for those of the body.
template <class Element, class Body>
Snapshot FemBody<Element, Body>::elements_of(const Rectilinear<D>& grid, const ActiveGrid<D>& active) const {
    Snapshot s{{"element", "x", "y", "flag"}};
    std::vector<int> flags(is_body_.size(), 0);
    for (std::size_t a = 0; a < active.elements.size(); ++a) flags[static_cast<std::size_t>(active.elements[a])] = active.flags[a];
    for (const int e : elements_) flags[static_cast<std::size_t>(e)] = -1;
    constexpr int n = Element::count - 1;
    std::vector<int> border;
    for (int i = 0; i < n; ++i) border.push_back(i);
    for (int i = 0; i < n; ++i) border.push_back(n + i * Element::count);
    for (int i = n; i > 0; --i) border.push_back(n * Element::count + i);
    for (int i = n; i > 0; --i) border.push_back(i * Element::count);
    for (int e = 0; e < grid.elements(); ++e)
        for (const int k : border) {
            const int I = grid.node(e, k);
            const Vec<D> x = grid.position(I) + node(I).u;
            s.add(std::array<double, 4>{static_cast<double>(e), x[0], x[D - 1], static_cast<double>(flags[static_cast<std::size_t>(e)])});
        }
    return s;
}

}  // namespace mpm
