/// Joins one scheme, one scene, one shape and one transfer into what the run loop and the report call.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lab/body.hpp"
#include "lab/boundary.hpp"
#include "lab/clock.hpp"
#include "lab/columns.hpp"
#include "lab/coverage.hpp"
#include "lab/locking.hpp"
#include "lab/monitor.hpp"
#include "lab/overlap.hpp"
#include "lab/program.hpp"
#include "lab/traits.hpp"

namespace mpm {

/// A scheme's point and node as the law and a transfer extend them.
template <class Scheme, class Law, class Transfer, int D>
using PointFor = typename Transfer::template PointOf<typename WithHistory<Law, typename Scheme::template PointOf<D>>::Point>;
template <class Scheme, class Transfer, int D> using NodeFor = typename Transfer::template NodeOf<typename Scheme::template NodeOf<D>>;

/// One resolution of a scene without its weights, shared by the functions that the run loop calls: compiled once for all shapes.
///
/// A scene tells its law, lattice(cells, nodes per cell), particles<Point>(cells, ppc), or bodies<Point>(cells, ppc) if there may be several,
/// load(body, t), fix(grid, field, t), speed(), wave_speed(), watch(points, t) and an Observer, both of which see the particles of all bodies. It
/// may also tell held_force(grid), the force on held velocity components, from which the momentum balance takes the impulse of walls;
/// supply(bodies, t, dt), impulse and work of its loads and of what holds nodes and moves; rigid(), particles {x, v} of rigid bodies;
/// animated(), what a gif shows; may_break, if gaps in its bodies are no defect; may_overlap, if bodies may lie in each other.
template <class Scene, class Matter> struct Problem {
    static constexpr int D = Scene::D;

    explicit Problem(const Scene& s) : scene(s), observer{scene} {}
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;

    Scene scene;
    std::vector<Matter*> bodies;
    std::vector<std::vector<typename Matter::Point>> good;  // the last state that was well
    std::vector<std::vector<std::uint32_t>> good_numbers;   // and the numbers of its points
    std::vector<Coverage<D>> coverage;                      // of bodies that can come apart
    std::vector<LockingWatch<Matter>> locking;              // of nearly incompressible solids in the plane
    bool watches_overlap = false;
    NodeWatch nodes;
    bool watches_nodes = false, looks_for_massless = false;  // every step; once
    double cutoff = 0;  // the scheme's, if it has one [mass]
    std::function<Mapping(std::size_t body)> mapping;  // of the weighting function, for --smooth
    std::function<Trouble()> shapes_trouble;           // of weighting functions that can fail, e.g. with domains
    std::function<double()> lost_in_coupling;          // energy so far, e.g. to friction
    std::function<Supply()> coupling_supply;           // of walls, since the last call
    typename Scene::Observer observer;

    AllPoints<Matter> points() const { return AllPoints<Matter>(bodies); }
    void keep() {
        good.resize(bodies.size());
        good_numbers.resize(bodies.size());
        for (std::size_t b = 0; b < good.size(); ++b) good[b] = bodies[b]->points, good_numbers[b] = bodies[b]->numbers;
    }
    void restore() {
        for (std::size_t b = 0; b < good.size(); ++b) bodies[b]->points = good[b], bodies[b]->numbers = good_numbers[b];
    }
    Measures measure() const {
        Measures sum;
        for (const Matter* body : bodies) add_measures(*body, sum);
        if (lost_in_coupling) sum.dissipated += lost_in_coupling();
        return sum;
    }
    Trouble check() const {
        for (const Matter* body : bodies)
            if (Trouble trouble = check_particles(*body)) return trouble;
        return {};
    }
    Trouble inspect() {
        for (std::size_t b = 0; b < coverage.size(); ++b)
            if (Trouble gap = coverage[b].check(*bodies[b])) return gap;
        for (std::size_t b = 0; b < locking.size(); ++b)
            if (Trouble trouble = locking[b].check(*bodies[b])) return trouble;
        if (shapes_trouble)
            if (Trouble trouble = shapes_trouble()) return trouble;
        if (looks_for_massless) {
            looks_for_massless = false;
            for (const Matter* body : bodies)
                if (Trouble trouble = massless_node<D>(*body, NodeWatch::tiny)) return trouble;
        }
        return watches_overlap ? check_overlap<D>(bodies) : Trouble{};
    }
    double critical_dt() const {
        double speed2 = 0;
        for (const auto& p : points()) speed2 = std::max(speed2, p.v.squaredNorm());
        return critical_step<D>(bodies[0]->grid.lattice().h(), scene.wave_speed(), std::sqrt(speed2));
    }
    /// After a step: the impulse of walls and loads, the work of loads, and a look at the nodes.
    Supply supply(double t, double dt) {
        Supply sum;
        if constexpr (requires { scene.supply(bodies, t, dt); }) sum = scene.supply(bodies, t, dt);
        if (coupling_supply) sum += coupling_supply();
        for (const Matter* body : bodies) {
            if (watches_nodes) nodes.look(*body, cutoff);
            if constexpr (requires { scene.held_force(body->grid); }) {
                const Vec<D> f = scene.held_force(body->grid);
                for (int d = 0; d < D; ++d) sum.impulse[static_cast<std::size_t>(d)] -= dt * f[d];
            }
        }
        return sum;
    }
};

/// All that the run loop calls but the step.
template <class Scene, class Matter> [[gnu::cold]] Simulation watched(const std::shared_ptr<Problem<Scene, Matter>>& s, double t_end) {
    Simulation sim;
    sim.measure = [s] { return s->measure(); };
    sim.check = [s] { return s->check(); };
    sim.inspect = [s] { return s->inspect(); };
    sim.where = [s] { return fastest_particle(s->bodies); };
    sim.supply = [s](double t, double dt) { return s->supply(t, dt); };
    sim.critical_dt = [s] { return s->critical_dt(); };
    sim.sample = [s](double t, double energy) { s->observer.sample(s->points(), t, energy); };
    sim.wants_energy = [s, t_end](double t) { return s->observer.wants_energy(t, t_end); };
    sim.watch = [s](double t) {
        const auto values = s->scene.watch(s->points(), t);
        return std::vector<double>(values.begin(), values.end());
    };
    sim.particles = [s] {
        if constexpr (requires { s->scene.rigid(); })
            return particles_of<Scene::D>(s->bodies, s->mapping, s->scene.rigid());
        else
            return particles_of<Scene::D>(s->bodies, s->mapping);
    };
    sim.nodes = [s] { return nodes_of<Scene::D>(s->bodies); };
    sim.keep = [s] { s->keep(); };
    sim.restore = [s] { s->restore(); };
    return sim;
}

/// A weighting function by value: its name, nodes per cell and axis, and the nodes a point touches along an axis.
struct ShapeFacts {
    const char* name;
    int per_cell, support;
};
template <class Kernel> constexpr ShapeFacts facts_of() { return {Kernel::name, Kernel::per_cell, Kernel::support}; }

/// What the weights and the scheme add to a problem, by value, so that what follows is compiled once for all of them.
struct Combination {
    ShapeFacts shape;
    const char *scheme, *transfer;
    bool total_lagrangian;
    double cutoff;  // [mass]
};

/// The rest of a resolution whose bodies stand: the watches, and all that the loop and the report call but the step.
template <class Scene, class Matter> [[gnu::cold]] Assembled watched_and_reported(const std::shared_ptr<Problem<Scene, Matter>>& s,
                                                                                  const Combination& combination, int cells,
                                                                                  const Common& common) {
    const Scene& scene = s->scene;
    const Vec<Scene::D> h = s->bodies[0]->grid.lattice().h();
    s->watches_nodes = !combination.total_lagrangian;
    s->looks_for_massless = combination.total_lagrangian;
    s->cutoff = combination.cutoff;
    if constexpr (!requires { Scene::may_break; })
        if (!combination.total_lagrangian)
            for (const Matter* body : s->bodies) s->coverage.emplace_back(*body, combination.shape.support);
    if constexpr (Scene::D == 2)
        if (can_lock(s->bodies[0]->law))
            for (const Matter* body : s->bodies) s->locking.emplace_back(*body, scene.wave_speed());
    if constexpr (!requires { Scene::may_overlap; }) s->watches_overlap = s->bodies.size() > 1;
    s->keep();
    Assembled a;
    a.simulation = watched(s, common.t_end);
    a.critical_dt = critical_step<Scene::D>(h, scene.wave_speed(), scene.speed());
    a.row.scene = Scene::name;
    a.row.reference = Scene::reference;
    a.row.scheme = combination.scheme;
    a.row.shape = combination.shape.name;
    a.row.transfer = combination.transfer;
    a.row.dim = Scene::D;
    a.row.cells = cells;
    a.row.h = h[0];
    a.row.ppc = common.ppc;
    a.row.threads = common.threads;
    for (const Matter* body : s->bodies) a.row.particles += static_cast<long>(body->points.size());
    a.row.bytes_per_particle = sizeof(typename Matter::Point);
    a.row.bytes_per_node = sizeof(typename Matter::Node);
    a.errors = [s](double t_end) { return s->observer.errors(t_end); };
    a.facts = [s](double t_end) { return s->observer.facts(t_end); };
    a.nodes = [s] { return s->nodes; };
    a.animated = animated_of(scene);
    if (!common.colour.empty() && common.colour != a.animated.colour) {
        a.animated.colour = common.colour;
        a.animated.colour_label = column_label(common.colour);
    }
    return a;
}

/// The bodies of a scene, without weights.
template <class Matter, class Scene>
[[gnu::cold]] std::vector<Matter> matter_of(const Scene& scene, const Lattice<Scene::D>& lattice, int cells, int ppc) {
    using Points = std::vector<typename Matter::Point>;
    std::vector<Points> bodies;
    if constexpr (requires { scene.template bodies<typename Matter::Point>(cells, ppc); })
        bodies = scene.template bodies<typename Matter::Point>(cells, ppc);
    else
        bodies.push_back(scene.template particles<typename Matter::Point>(cells, ppc));
    std::vector<Matter> all;
    for (const Points& points : bodies) {
        Points kept;
        reserve_large(kept, points.size());
        kept = points;
        all.push_back({std::move(kept), Grid<Scene::D, typename Matter::Node>(lattice), scene.law()});
    }
    return all;
}

/// `make_shape(lattice, points)` gives a body's weighting function. A coupling that takes energy tells `dissipated`, one with walls
/// `supply`.
template <class Shape, class Scheme, class Scene, class Transfer, class MakeShape, class Coupling = Free>
[[gnu::cold]] Assembled assemble(const Scheme& scheme, const Scene& scene, const Transfer& transfer, const ShapeFacts& facts, int cells,
                                 const Common& common, MakeShape&& make_shape, const Coupling& coupling = {}) {
    constexpr int D = Scene::D;
    using Law = typename Scene::Law;
    using Point = PointFor<Scheme, Law, Transfer, D>;
    using Node = NodeFor<Scheme, Transfer, D>;
    using Substance = Matter<D, Point, Node, Law>;
    using OneBody = Body<D, Point, Node, Law, Shape, Transfer>;
    struct Moved {
        Scheme scheme;
        std::vector<OneBody> bodies;
        [[no_unique_address]] Coupling coupling;
    };
    const Lattice<D> lattice = scene.lattice(cells, facts.per_cell);
    auto problem = std::make_shared<Problem<Scene, Substance>>(scene);
    auto moved = std::make_shared<Moved>(Moved{scheme, {}, coupling});
    for (Substance& matter : matter_of<Substance>(scene, lattice, cells, common.ppc)) {
        Shape shape = make_shape(lattice, matter.points);
        moved->bodies.push_back(OneBody{std::move(matter), std::move(shape), transfer});
    }
    if constexpr (requires { scheme.start(moved->bodies, scene); }) moved->scheme.start(moved->bodies, scene);
    for (OneBody& body : moved->bodies) problem->bodies.push_back(&body);
    for (OneBody& body : moved->bodies) body.grid.use_threads(common.threads);
    if constexpr (!goes_by_corners<Shape>)
        if (common.smooth) problem->mapping = [moved](std::size_t b) { return mapping_of(moved->bodies[b].shape, moved->bodies[b].points); };
    if constexpr (requires(const OneBody& body) { body.shape.trouble(body); })
        problem->shapes_trouble = [moved] {
            for (const OneBody& body : moved->bodies)
                if (Trouble trouble = body.shape.trouble(body)) return trouble;
            return Trouble{};
        };
    if constexpr (requires { moved->coupling.dissipated(); })
        problem->lost_in_coupling = [moved] { return moved->coupling.dissipated(); };
    if constexpr (requires { moved->coupling.supply(); }) problem->coupling_supply = [moved] { return moved->coupling.supply(); };
    Combination combination{facts, Scheme::name, transfer.name, Shape::total_lagrangian, 0};
    if constexpr (requires { scheme.cutoff; }) combination.cutoff = scheme.cutoff;
    Assembled a = watched_and_reported(problem, combination, cells, common);
    if constexpr (goes_by_corners<Shape> && D == 2) {
        a.simulation.domains = [moved] { return domains_of(moved->bodies); };
        a.animated.domains = true;
    }
    a.simulation.step = [moved, problem](double t, double dt) {
        if constexpr (may_reorder<OneBody, Scene>)
            for (OneBody& body : moved->bodies)
                if (body.order.keep(static_cast<Substance&>(body))) body.strips.forget();
        moved->scheme.step(moved->bodies, moved->coupling, problem->scene, t, dt);
    };
    return a;
}

}  // namespace mpm
