/// Joins implicit MPM and a scene into what the run loop and the report call, and declares the method's options.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/implicit/implicit.hpp"
#include "chapters/implicit/newton_file.hpp"
#include "lab/columns.hpp"
#include "lab/program.hpp"
#include "lab/traits.hpp"

namespace mpm {

/// The method's options, as they are on the command line.
struct ImplicitOptions {
    double beta = 0.25, gamma = 0.5, tolerance = 1e-10, soft_few = 0, soft_some = 0, receding = 0;
    std::string carry = "particle", tangent = "analytic", inactive = "left-out";
    int cuts = 8, iterations = 30;
    bool newton = false;

    void declare(Options& o, bool plane);
    /// Throws BadInput where options do not go together.
    ImplicitSettings settings(const Options& o, int threads) const;
};

/// Where newton.csv of one resolution goes; "" if it was not asked for.
std::string newton_path(const std::string& program, const Options& options, const Common& common, int cells, const ImplicitOptions& method);

/// The command line of a program in the plane with Q9 elements, whose defaults the caller has set.
template <class Scene>
void declare_plane(Options& options, Scene& scene, ImplicitOptions& method, Common& common, double t_end) {
    common.shape = QuadraticElement::name;
    method.beta = 0.3;
    scene.declare(options);
    method.declare(options, true);
    common.declare(options, {QuadraticElement::name}, t_end, traits_of(scene));
    common.declare_threads(options);
}
/// What it means once read; `counts` are the options that place the scene's particles. Throws BadInput.
inline void settle_plane(const Options& options, ImplicitOptions& method, Common& common, const std::string& counts) {
    if (options.given("ppc")) throw BadInput("--ppc: " + counts + " say how many particles there are");
    if (options.given("cfl")) common.dt = 0;
    if (!options.given("soft-some")) method.soft_some = 1e-4 * method.soft_few;
}

/// A node of the grid of finite elements keeps nothing between steps.
struct NoNode {
    void reset() {}
};

template <class Scene>
using ImplicitMatter =
    Matter<Scene::D, typename WithHistory<typename Scene::Law, ImplicitPoint<Scene::D>>::Point, NoNode, typename Scene::Law>;

/// One resolution of a scene. It tells its law, lines(cells) of its grid along each axis, particles<Point>(cells, ppc), what ImplicitMpm
/// asks for (implicit.hpp), speed(), wave_speed(), watch(points, t) and an Observer.
template <class Scene> struct ImplicitProblem {
    using Body = ImplicitMatter<Scene>;
    explicit ImplicitProblem(const Scene& s) : scene(s), observer{scene} {}
    ImplicitProblem(const ImplicitProblem&) = delete;
    ImplicitProblem& operator=(const ImplicitProblem&) = delete;

    Scene scene;
    Body body;
    std::vector<typename Body::Point> good;
    typename Scene::Observer observer;
    double smallest = 0;  // element
    double critical_dt() const {
        double speed2 = 0;
        for (const auto& p : body.points) speed2 = std::max(speed2, p.v.squaredNorm());
        return smallest / (scene.wave_speed() + std::sqrt(speed2));
    }
};

/// Nodes of a grid of elements: places, and whether they are active.
template <int D> GridSnapshot nodes_of(const Rectilinear<D>& grid, const ActiveGrid<D>& active) {
    GridSnapshot s;
    s.columns = D == 1 ? std::vector<std::string>{"body", "x", "active"} : std::vector<std::string>{"body", "x", "y", "active"};
    for (int I = 0; I < grid.size(); ++I) {
        const Vec<D> x = grid.position(I);
        s.values.push_back(0);
        for (int d = 0; d < D; ++d) s.values.push_back(x[d]);
        s.values.push_back(active.node_is_active.empty() ? 0 : active.node_is_active[static_cast<std::size_t>(I)]);
    }
    return s;
}

/// The elements with their flags M_E, 0 without particles, as rectangles corner by corner.
inline Snapshot elements_of(const Rectilinear<2>& grid, const ActiveGrid<2>& active) {
    Snapshot s{{"element", "x", "y", "flag"}};
    std::vector<int> flags(static_cast<std::size_t>(grid.elements()), 0);
    for (std::size_t a = 0; a < active.elements.size(); ++a) flags[static_cast<std::size_t>(active.elements[a])] = active.flags[a];
    for (int e = 0; e < grid.elements(); ++e)
        for (const auto& [i, j] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            s.add(std::array<double, 4>{static_cast<double>(e), grid.low(e, 0) + i * grid.size(e, 0), grid.low(e, 1) + j * grid.size(e, 1),
                                        static_cast<double>(flags[static_cast<std::size_t>(e)])});
    return s;
}

/// `AttachedOf<Element, Body>` shares the grid with the particles (alone.hpp); a scene's watch and observer may look at it, and a scene may
/// tell the longest step that it wants now, step(points, attached), which --cfl is then a part of with --dt-from step.
template <class Element, template <class, class> class AttachedOf = Alone, class Scene>
[[gnu::cold]] Assembled assemble_implicit(const Scene& scene, const ImplicitSettings& settings, int cells, const Common& common,
                                          const std::string& newton_file = "") {
    constexpr int D = Scene::D;
    using Body = ImplicitMatter<Scene>;
    using Method = ImplicitMpm<Element, Body, Scene, AttachedOf<Element, Body>>;
    auto s = std::make_shared<ImplicitProblem<Scene>>(scene);
    s->body.points = s->scene.template particles<typename Body::Point>(cells, common.ppc);
    s->body.law = s->scene.law();
    const Rectilinear<D> grid(s->scene.lines(cells), sharing_of<Element>());
    s->smallest = grid.size(0, 0);
    for (int e = 0; e < grid.elements(); ++e)
        for (int d = 0; d < D; ++d) s->smallest = std::min(s->smallest, grid.size(e, d) / Element::stride);
    auto method = std::make_shared<Method>(settings, grid, s->body, s->scene);
    s->good = s->body.points;
    auto log = std::make_shared<NewtonFile>(newton_file);
    method->keep_history(!newton_file.empty());

    Assembled a;
    Simulation& sim = a.simulation;
    sim.any_step = true;
    sim.step = [s, method](double t, double dt) { method->step(t, dt); };
    sim.measure = [s, method] {
        Measures sum;
        add_measures(s->body, sum);
        method->attached().measure(sum);
        sum.dissipated += method->counts().soft_work;
        return sum;
    };
    sim.check = [s, method, log] {
        log->write(method->history());
        return method->trouble() ? method->trouble() : check_particles(s->body);
    };
    sim.inspect = [] { return Trouble{}; };
    sim.where = [s] { return fastest_particle(std::vector<Body*>{&s->body}); };
    sim.supply = [method](double, double) { return method->supply(); };
    sim.critical_dt = [s, method] {
        if constexpr (requires { s->scene.step(s->body.points, method->attached()); })
            return s->scene.step(s->body.points, method->attached());
        else return s->critical_dt();
    };
    sim.sample = [s, method](double t, double energy) {
        if constexpr (requires { s->observer.sample(s->body.points, method->attached(), t, energy); })
            s->observer.sample(s->body.points, method->attached(), t, energy);
        else s->observer.sample(s->body.points, t, energy);
    };
    sim.wants_energy = [s, t_end = common.t_end](double t) { return s->observer.wants_energy(t, t_end); };
    sim.watch = [s, method](double t) {
        const auto values = [&] {
            if constexpr (requires { s->scene.watch(s->body.points, method->attached(), t); })
                return s->scene.watch(s->body.points, method->attached(), t);
            else return s->scene.watch(s->body.points, t);
        }();
        return std::vector<double>(values.begin(), values.end());
    };
    sim.particles = [s, method] {
        std::vector<const Body*> bodies{&s->body};
        for (const Body* other : method->attached().bodies()) bodies.push_back(other);
        return particles_of<D>(bodies);
    };
    sim.nodes = [method] { return nodes_of<D>(method->grid(), method->active()); };
    if constexpr (D == 2)
        sim.domains = [method] {
            if constexpr (requires { method->attached().elements_of(method->grid(), method->active()); })
                return method->attached().elements_of(method->grid(), method->active());
            else return elements_of(method->grid(), method->active());
        };
    sim.keep = [s, method] { s->good = s->body.points, method->attached().keep(); };
    sim.restore = [s, method] { s->body.points = s->good, method->attached().restore(); };
    a.critical_dt = s->smallest / (s->scene.wave_speed() + s->scene.speed());
    a.row.scene = Scene::name;
    a.row.reference = Scene::reference;
    a.row.scheme = by_midpoint(settings.carry) ? "implicit-midpoint" : "implicit-newmark";
    a.row.shape = Element::name;
    a.row.transfer = carry_names()[static_cast<std::size_t>(settings.carry)];
    a.row.dim = D;
    a.row.cells = cells;
    a.row.h = grid.size(0, 0);
    a.row.ppc = common.ppc;
    a.row.threads = common.threads;
    a.row.particles = static_cast<long>(s->body.points.size());
    a.row.bytes_per_particle = sizeof(typename Body::Point);
    a.row.bytes_per_node = 0;
    a.errors = [s](double t_end) { return s->observer.errors(t_end); };
    a.facts = [s, method](double t_end) {
        auto facts = s->observer.facts(t_end);
        if constexpr (requires { method->attached().add_facts(facts); }) method->attached().add_facts(facts);
        add_facts(method->counts(), facts);
        return facts;
    };
    a.nodes = [] { return NodeWatch{}; };
    a.animated = animated_of(s->scene);
    if (!common.colour.empty() && common.colour != a.animated.colour)
        a.animated.colour = common.colour, a.animated.colour_label = column_label(common.colour);
    return a;
}

}  // namespace mpm
