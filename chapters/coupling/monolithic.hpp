/// A finite element body in one system with implicit MPM (Aulisa and Capodaglio, section 4): some elements of the grid are the body, the
/// others are the background that is attached to it. Shared nodes make the contact: both bodies' residuals are added there, and nothing
/// searches for it.
///
/// The body is integrated by Gauss points, which the residual of residual.hpp takes for particles that never leave their element: F^n is
/// that of the nodes (39), velocity and acceleration are interpolated from them (42, 43), and Newmark's rule acts at the nodes after the
/// step (46). In the printed (38) and (41) the factors of the density do not agree; here they are those of (20).
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "chapters/coupling/exchange.hpp"
#include "chapters/coupling/reset.hpp"
#include "chapters/implicit/implicit.hpp"
#include "lab/snapshot.hpp"

namespace mpm {

/// Joins ImplicitMpm as its `Attached`. The scene tells fem_elements(grid), fem_law(), of several materials fem_material(X), also
/// fem_body_force(t), reset_held(grid) (reset.hpp) and, if the body does not start at rest, fem_start(X, node), which sets u, v and a of a
/// node.
template <class Element, class Body> class FemBody {
public:
    static constexpr bool any = true;
    static constexpr int D = Body::D, N = power(Element::count, D);
    static_assert(Element::stride == Element::count - 1, "the body's displacement needs Lagrange elements");
    using Point = typename Body::Point;
    struct NodeState {
        static constexpr int D = Body::D;
        Vec<D> u = Vec<D>::Zero(), v = Vec<D>::Zero(), a = Vec<D>::Zero();  // displacement, velocity, acceleration
    };

    template <class Scene>
    void attach(const Rectilinear<D>& grid, const Scene& scene, const std::vector<char>& held, const std::vector<Point>& particles);

    // What ImplicitMpm asks for, in this order (alone.hpp).
    template <class Scene> void begin(const StepOf<D>& step, const Scene& scene, double t) {
        step_ = step;
        step_.b = scene.fem_body_force(t + step.newmark.theta * step.dt);
    }
    int element(const Rectilinear<D>&, std::size_t i, const Point&) const { return places_[i].element; }
    auto weights(const Rectilinear<D>& grid, int element, std::size_t i, const Point&) const {
        auto w = element_weights<Element, D>(grid, element, places_[i].X);
        if (!flat_) deform(w, gradient(grid, element, w));
        return w;
    }
    bool recedes(const RecedingContact& contact, const Rectilinear<D>& grid, int element, std::size_t i, const Point& p) const;
    const std::vector<int>& elements() const { return elements_; }
    template <class Visit> bool each_point(const Rectilinear<D>& grid, std::size_t k, Visit&& visit) const {
        for (std::size_t q = k * N; q < (k + 1) * N; ++q) {
            const Point& p = gauss_.points[q];
            auto w = element_weights<Element, D>(grid, elements_[k], p.X);
            deform(w, p.F);
            if (!visit(p, law(p), w, step_)) return false;
        }
        return true;
    }
    /// Whether no element of the body would be turned inside out at a Gauss point or a node.
    bool accepts(const Rectilinear<D>& grid, const std::vector<double>& u, const std::vector<int>& number) const;
    /// Moves the body by the increment u, resets the background and finds the particles in it. Returns the work of the body force.
    double move(const Rectilinear<D>& grid, const std::vector<double>& u, const std::vector<int>& number,
                const std::vector<Point>& particles);
    Vec<D> force() const { return mass_ * step_.b; }
    Trouble trouble() const { return trouble_; }
    /// Residuals that both bodies have given to the nodes in the step.
    void exchange(const std::vector<double>& of_particles, const std::vector<double>& of_body, const std::vector<int>& number) {
        exchange_.add(of_particles, of_body, number, is_body_node_, step_.dt);
    }

    void keep() { good_ = {nodes_, gauss_.points, places_}; }
    void restore() { nodes_ = good_.nodes, gauss_.points = good_.points, places_ = good_.places, flat_ = false; }
    void measure(Measures& sum) const { add_measures(gauss_, sum); }
    std::vector<const Body*> bodies() const { return {&gauss_}; }
    void add_facts(std::vector<std::pair<std::string, double>>& facts) const;
    Snapshot elements_of(const Rectilinear<D>& grid, const ActiveGrid<D>& active) const;

    const Body& gauss() const { return gauss_; }
    const Exchange<D>& exchange() const { return exchange_; }
    /// Displacement of a node from its undeformed place.
    const NodeState& node(int I) const { return nodes_[static_cast<std::size_t>(I)]; }
    bool is_body_node(int I) const { return is_body_node_[static_cast<std::size_t>(I)] != 0; }
    long inside() const { return inside_; }
    /// The lowest displacement of the body's nodes along an axis.
    double deepest(int axis) const {
        double least = 0;
        for (std::size_t I = 0; I < nodes_.size(); ++I)
            if (is_body_node_[I]) least = std::min(least, nodes_[I].u[axis]);
        return least;
    }

private:
    struct Place {
        int element;
        Vec<D> X;  // in the undeformed grid
    };
    struct Good {
        std::vector<NodeState> nodes;
        std::vector<Point> points;
        std::vector<Place> places;
    };
    const NeoHookean& law(const Point& p) const {
        if constexpr (requires { gauss_.law.law(p); }) return gauss_.law.law(p);
        else return gauss_.law;
    }
    template <class Weights> static void deform(Weights& w, const Mat<D>& F) {
        const Mat<D> F_invT = cofactor(F) / F.determinant();
        for (auto& g : w.grad) g = F_invT * g;
        w.trial = w.grad;
    }
    /// 1 + grad u of the undeformed grid, by its weights.
    template <class Weights> Mat<D> gradient(const Rectilinear<D>& grid, int element, const Weights& w) const {
        Mat<D> F = identity<D>();
        for (int k = 0; k < N; ++k) F += node(grid.node(element, k)).u * w.grad[static_cast<std::size_t>(k)].transpose();
        return F;
    }
    template <class Field, class Weights>
    Vec<D> at(const Rectilinear<D>& grid, int element, const Weights& w, Field NodeState::* field) const {
        Vec<D> sum = Vec<D>::Zero();
        for (int k = 0; k < N; ++k) sum += w.phi[static_cast<std::size_t>(k)] * (node(grid.node(element, k)).*field);
        return sum;
    }
    void refresh(const Rectilinear<D>& grid);
    void reset(const Rectilinear<D>& grid);
    void find(const Rectilinear<D>& grid, const std::vector<Point>& particles);
    bool find_one(const Rectilinear<D>& grid, const Vec<D>& x, Place& place) const;

    std::vector<int> elements_;
    std::vector<char> is_body_, is_body_node_;  // of each element, of each node
    Body gauss_;                                // Gauss points, N of each element
    double mass_ = 0;
    std::vector<NodeState> nodes_;              // u of all nodes at the start of a step; v and a of the body's
    ElasticExtension<Element, D> extension_;
    bool flat_ = true;                          // no node is displaced
    std::vector<Place> places_;                 // of the particles
    StepOf<D> step_{};
    Exchange<D> exchange_;
    long inside_ = 0;                           // particles found in the body, over all steps
    Trouble trouble_;
    Good good_;
};

}  // namespace mpm

#include "chapters/coupling/monolithic_steps.hpp"
