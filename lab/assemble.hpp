/// Joins one scheme, one scene, one shape and one transfer into what the run loop and the report call.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lab/body.hpp"
#include "lab/boundary.hpp"
#include "lab/clock.hpp"
#include "lab/coverage.hpp"
#include "lab/monitor.hpp"
#include "lab/program.hpp"
#include "lab/snapshot.hpp"

namespace mpm {

/// A scheme's point and node as a transfer extends them.
template <class Scheme, class Transfer, int D> using PointFor = typename Transfer::template PointOf<typename Scheme::template PointOf<D>>;
template <class Scheme, class Transfer, int D> using NodeFor = typename Transfer::template NodeOf<typename Scheme::template NodeOf<D>>;

/// One resolution of one problem, alive as long as the functions of `Assembled` that share it.
///
/// A scene tells its law, lattice(cells, nodes per cell), particles<Point>(cells, ppc), load(body, t), fix(grid, field, t), speed(), watch(points, t) and an Observer.
/// It may also tell held_force(grid), the force on held velocity components, from which the momentum balance takes the impulse of walls;
/// supply(bodies, t, dt), impulse and work of its loads; may_break, if gaps in its bodies are no defect; animated(), what a gif shows.
template <class Scheme, class Scene, class Shape, class Transfer> struct Problem {
    static constexpr int D = Scene::D;
    using Point = PointFor<Scheme, Transfer, D>;
    using Node = NodeFor<Scheme, Transfer, D>;
    using OneBody = Body<D, Point, Node, typename Scene::Law, Shape, Transfer>;

    Problem(const Scheme& a, const Scene& b) : scheme(a), scene(b), observer{scene} {}
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;

    Scheme scheme;
    Scene scene;
    std::vector<OneBody> bodies;
    std::vector<std::vector<Point>> good;  // the last state that was well
    std::vector<Coverage<D>> coverage;     // of bodies that can come apart
    NodeWatch nodes;
    typename Scene::Observer observer;

    void start() {
        if constexpr (requires { scheme.start(bodies, scene); }) scheme.start(bodies, scene);
        if constexpr (!Shape::total_lagrangian && !requires { Scene::may_break; })
            for (const auto& body : bodies) coverage.emplace_back(body, Shape::N);
        keep();
    }
    void keep() {
        good.clear();
        for (const auto& body : bodies) good.push_back(body.points);
    }
    void restore() {
        for (std::size_t b = 0; b < good.size(); ++b) bodies[b].points = good[b];
    }
    Trouble inspect() {
        for (std::size_t b = 0; b < coverage.size(); ++b)
            if (Trouble gap = coverage[b].check(bodies[b])) return gap;
        return {};
    }
    double critical_dt() const {
        double speed2 = 0;
        for (const auto& body : bodies)
            for (const auto& p : body.points) speed2 = std::max(speed2, p.v.squaredNorm());
        return critical_step<D>(bodies[0].grid.lattice().h(), scene.wave_speed(), std::sqrt(speed2));
    }
    /// After a step: the impulse of walls and loads, the work of loads, and a look at the nodes.
    Supply supply(double t, double dt) {
        double cutoff = 0;
        if constexpr (requires { scheme.cutoff; }) cutoff = scheme.cutoff;
        if constexpr (!Shape::total_lagrangian) nodes.look(bodies, cutoff);
        Supply sum;
        if constexpr (requires { scene.supply(bodies, t, dt); }) sum = scene.supply(bodies, t, dt);
        if constexpr (requires { scene.held_force(bodies[0].grid); })
            for (const auto& body : bodies) {
                const Vec<D> f = scene.held_force(body.grid);
                for (int d = 0; d < D; ++d) sum.impulse[static_cast<std::size_t>(d)] -= dt * f[d];
            }
        return sum;
    }
};

/// The functions that the run loop calls, on a problem whose bodies stand.
template <class P> Simulation simulate(const std::shared_ptr<P>& s, double t_end) {
    Simulation sim;
    sim.step = [s](double t, double dt) { s->scheme.step(s->bodies, Free{}, s->scene, t, dt); };
    sim.measure = [s] { return measure(s->bodies); };
    sim.check = [s] { return check_particles(s->bodies); };
    sim.inspect = [s] { return s->inspect(); };
    sim.where = [s] { return fastest_particle(s->bodies); };
    sim.supply = [s](double t, double dt) { return s->supply(t, dt); };
    sim.critical_dt = [s] { return s->critical_dt(); };
    sim.sample = [s](double t, double energy) { s->observer.sample(s->bodies[0].points, t, energy); };
    sim.wants_energy = [s, t_end](double t) { return s->observer.wants_energy(t, t_end); };
    sim.watch = [s](double t) {
        const auto values = s->scene.watch(s->bodies[0].points, t);
        return std::vector<double>(values.begin(), values.end());
    };
    sim.write_particles = [s](const std::string& path) { write_particles(path, s->bodies); };
    sim.write_nodes = [s](const std::string& path) { write_nodes(path, s->bodies); };
    sim.keep = [s] { s->keep(); };
    sim.restore = [s] { s->restore(); };
    return sim;
}

/// `make_shape(lattice, points)` gives the body's weighting function.
template <class Shape, class Scheme, class Scene, class Transfer, class MakeShape>
Assembled assemble(const Scheme& scheme, const Scene& scene, const Transfer& transfer, int cells, const Common& common, MakeShape&& make_shape) {
    using P = Problem<Scheme, Scene, Shape, Transfer>;
    auto s = std::make_shared<P>(scheme, scene);
    const Lattice<P::D> lattice = scene.lattice(cells, Shape::Kernel::per_cell);
    auto points = scene.template particles<typename P::Point>(cells, common.ppc);
    Shape shape = make_shape(lattice, points);
    s->bodies.push_back({std::move(points), Grid<P::D, typename P::Node>(lattice), scene.law(), std::move(shape), transfer});
    s->start();

    Assembled a;
    a.simulation = simulate(s, common.t_end);
    a.critical_dt = critical_step<P::D>(lattice.h(), scene.wave_speed(), scene.speed());
    a.row.scene = Scene::name;
    a.row.scheme = Scheme::name;
    a.row.shape = Shape::Kernel::name;
    a.row.transfer = Transfer::name;
    a.row.dim = P::D;
    a.row.cells = cells;
    a.row.h = lattice.h()[0];
    a.row.ppc = common.ppc;
    a.row.reference = Scene::reference;
    a.row.particles = static_cast<long>(s->bodies[0].points.size());
    a.row.bytes_per_particle = sizeof(typename P::Point);
    a.row.bytes_per_node = sizeof(typename P::Node);
    a.errors = [s](double t_end) { return s->observer.errors(t_end); };
    a.facts = [s](double t_end) { return s->observer.facts(t_end); };
    a.nodes = [s] { return s->nodes; };
    if constexpr (requires { scene.animated(); }) a.animated = scene.animated();
    else if constexpr (P::D == 2) a.animated = {"x", "y", "sxx", "x [length]", "y [length]", "σ_{xx} [force/area]"};
    return a;
}

}  // namespace mpm
