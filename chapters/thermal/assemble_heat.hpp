/// Joins heat conduction, a hot body and a weighting function into what the run loop and the report call.
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/thermal/heat.hpp"
#include "chapters/weighting/shapes.hpp"
#include "chapters/weighting/tensor.hpp"
#include "lab/program.hpp"

namespace mpm {

/// Smooth functions are worth little here: temperatures have no cells to cross.
using HeatShapes = ShapeList<Hat, Ugimp, Cubic>;

/// Heat that flowed in during a step: from sources and through the boundary, and what held nodes gave beside that.
template <class Grid, class IsHeld> double heat_supplied(const Grid& grid, double dt, IsHeld&& is_held) {
    double sum = 0;
    for (int I = 0; I < grid.size(); ++I) {
        const auto& node = grid[I];
        sum += dt * node.Q_ext;
        if (is_held(I)) sum += node.C * (node.T_tilde - node.T) - dt * node.Q;
    }
    return sum;
}

/// One resolution while it runs. The stored heat takes the place of the strain energy.
template <class Scene, class Shape> struct HeatRun {
    static constexpr int D = Scene::D;
    using Thermal = Body<D, HeatPoint<D>, HeatNode, Conductor, Shape, int>;

    Heat scheme;
    Scene scene;
    double t_end;
    std::vector<Thermal> bodies{};
    std::vector<HeatPoint<D>> good{};  // the last state that was well
    double heat_in = 0, t = 0;

    Thermal& body() { return bodies.front(); }
    /// Heat, counted from the lowest temperature.
    double stored() {
        const double low = scene.range(t_end)[0];
        double sum = 0;
        for (const auto& p : body().points) sum += body().law.heat(p, low);
        return sum;
    }
    double scale() const { return scene.range(t_end)[1] - scene.range(t_end)[0]; }

    /// Conduction only evens out: temperatures beyond those of start and boundary by half their range are none.
    Trouble check() {
        const auto [low, high] = scene.range(t_end);
        const double margin = (high - low) / 2;
        for (std::size_t i = 0; i < body().points.size(); ++i) {
            const auto& p = body().points[i];
            if (p.T > low - margin && p.T < high + margin) continue;
            return {std::isfinite(p.T) ? "temperature-growth" : "not-finite", detail::place(i, p) + " has T = " + number_text(p.T) +
                                                                                  ", heat conduction keeps it in " + number_text(low) +
                                                                                  " ... " + number_text(high)};
        }
        return {};
    }
    std::string hottest() {
        std::size_t i = 0;
        for (std::size_t k = 0; k < body().points.size(); ++k)
            if (body().points[k].T > body().points[i].T) i = k;
        return detail::place(i, body().points[i]) + " is the hottest, T = " + number_text(body().points[i].T);
    }
    /// Temperature of the grid at x.
    double at(const Vec<D>& x) {
        double T = 0;
        for (const auto& e : body().shape.at(x, body().points.front())) T += e.phi * body().grid[e.node].T_new;
        return T;
    }
    std::vector<double> watch(double now) {
        t = now;
        const Vec<D> middle = scene.size() / 2;
        return {at(middle), scene.exact(middle, now), stored(), heat_in};
    }

    /// Root mean squares and largest values of the difference to the exact temperature, relative to the range of temperatures; `boundary`
    /// is of particles less than two cells from a heated side.
    std::vector<NamedError> errors() {
        Deviation nodes, particles, boundary;
        auto& grid = body().grid;
        const double per_scale = 1 / scale(), layer = 2 * grid.lattice().h().maxCoeff() * (1 - 1e-9);
        for (int I = 0; I < grid.size(); ++I)
            nodes.add(grid[I].C, (grid[I].T_new - scene.exact(grid.lattice().position(I), t)) * per_scale);
        for (const auto& p : body().points) {
            const double e = (p.T - scene.exact(p.x, t)) * per_scale;
            particles.add(p.V, e);
            if (scene.depth(p.x) < layer) boundary.add(p.V, e);
        }
        std::vector<NamedError> all{
            {"nodes", nodes.rms()}, {"particles", particles.rms()}, {"nodes_max", nodes.largest}, {"particles_max", particles.largest}};
        if (boundary.weight > 0) all.push_back({"boundary", boundary.rms()});
        return all;
    }
    struct Deviation {
        double sum2 = 0, weight = 0, largest = 0;
        void add(double w, double e) { sum2 += w * e * e, weight += w, largest = std::max(largest, std::abs(e)); }
        double rms() const { return std::sqrt(sum2 / weight); }
    };

    Snapshot particles() {
        Snapshot s{{"body", "x", "T", "q", "V"}};
        if (D == 2) s.columns = {"body", "x", "y", "T", "qx", "qy", "V"};
        for (const auto& p : body().points) {
            if constexpr (D == 1)
                s.add(std::array<double, 5>{0, p.x[0], p.T, p.q[0], p.V});
            else
                s.add(std::array<double, 7>{0, p.x[0], p.x[1], p.T, p.q[0], p.q[1], p.V});
        }
        return s;
    }
    GridSnapshot nodes() {
        GridSnapshot s;
        s.columns = {"body", "x"};
        if (D == 2) s.columns.emplace_back("y");
        s.columns.insert(s.columns.end(), {"C", "T", "T_exact"});
        const auto& grid = body().grid;
        for (int d = 0; d < D; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            s.nodes[axis] = grid.lattice().nodes(d), s.origin[axis] = grid.lattice().origin()[d], s.spacing[axis] = grid.lattice().h()[d];
        }
        for (int I = 0; I < grid.size(); ++I) {
            const Vec<D> x = grid.lattice().position(I);
            s.values.push_back(0);
            s.values.insert(s.values.end(), x.data(), x.data() + D);
            s.values.insert(s.values.end(), {grid[I].C, grid[I].T_new, scene.exact(x, t)});
        }
        return s;
    }
};

/// One resolution.
template <class Kernel, class Scene> Assembled assemble_heat(const Heat& scheme, const Scene& scene, int cells, const Common& common) {
    constexpr int D = Scene::D;
    using Shape = Tensor<D, Kernel>;
    using Run = HeatRun<Scene, Shape>;
    const Lattice<D> lattice = scene.lattice(cells, Kernel::per_cell);
    auto r = std::make_shared<Run>(Run{scheme, scene, common.t_end});
    r->bodies.push_back({{scene.template particles<HeatPoint<D>>(lattice, common.ppc), Grid<D, HeatNode>(lattice), scene.law()},
                         Shape{lattice, sized<Kernel>(common.ppc)},
                         0});
    r->body().grid.use_threads(common.threads);
    r->scheme.start(r->bodies);
    r->good = r->body().points;

    Assembled a;
    Simulation& sim = a.simulation;
    sim.step = [r](double t, double dt) { r->scheme.step(r->bodies, r->scene, t, dt); };
    sim.measure = [r] {
        Measures m;
        m.strain = r->stored();
        return m;
    };
    sim.check = [r] { return r->check(); };
    sim.inspect = [] { return Trouble{}; };
    sim.where = [r] { return r->hottest(); };
    sim.supply = [r](double t, double dt) {
        r->t = t + dt;
        const auto& grid = r->body().grid;
        const double heat = heat_supplied(grid, dt, [&](int I) { return r->scene.is_held(grid.lattice(), I); });
        r->heat_in += heat;
        Supply s;
        s.work = heat;
        return s;
    };
    const double critical = conduction_step<D>(lattice.h(), scene.law().diffusivity());
    sim.critical_dt = [critical] { return critical; };
    sim.sample = [](double, double) {};
    sim.wants_energy = [](double) { return false; };
    sim.watch = [r](double t) { return r->watch(t); };
    sim.particles = [r] { return r->particles(); };
    sim.nodes = [r] { return r->nodes(); };
    sim.keep = [r] { r->good = r->body().points; };
    sim.restore = [r] { r->body().points = r->good; };

    a.critical_dt = critical;
    a.errors = [r](double) { return r->errors(); };
    a.facts = [r](double) {
        std::vector<std::pair<std::string, double>> facts;
        for (const NamedError& e : r->errors()) facts.emplace_back("error / range, " + e.name, e.value);
        const auto now = r->watch(r->t);
        facts.insert(facts.end(), {{"temperature in the middle", now[0]}, {"the same, exact", now[1]}});
        return facts;
    };
    a.nodes = [] { return NodeWatch{}; };
    a.animated = D == 1 ? Animated{"x", "T", "", "x [length]", "temperature T [temperature]", ""}
                        : Animated{"x", "y", "T", "x [length]", "y [length]", column_label("T")};
    a.row.scene = Scene::name;
    a.row.reference = Scene::reference;
    a.row.scheme = Heat::name;
    a.row.shape = Kernel::name;
    a.row.transfer = "flip";
    a.row.dim = D;
    a.row.cells = cells;
    a.row.h = lattice.h()[0];
    a.row.ppc = common.ppc;
    a.row.threads = common.threads;
    a.row.particles = static_cast<long>(r->body().points.size());
    a.row.bytes_per_particle = sizeof(HeatPoint<D>);
    a.row.bytes_per_node = sizeof(HeatNode);
    return a;
}

/// Runs heat conduction in a bar or a plate: the body of both programs.
template <class Scene> int heat_program(const std::string& program, const std::string& purpose, const HotBodySettings& defaults,
                                        Common common, int argc, char** argv) {
    constexpr int D = Scene::D;
    return guarded(program, [&] {
        Options options(program, purpose);
        HotBodySettings settings = defaults;
        Heat scheme;
        std::string form = "mended";
        settings.declare(options, D == 2);
        options.choice("form", form, {"mended", "printed"}, "held nodes: the new temperature, or that at t too, as line 10 is printed");
        SceneTraits traits;
        traits.period = true;
        traits.limit = D == 1 ? "h^2/(2 kappa)" : "h^2/(4 kappa)";
        if (D == 2) traits.colours = {"T", "qx", "qy"}, traits.colour = "T";
        common.declare(options, HeatShapes::names(), 0.05, traits);
        if (D == 2) common.declare_threads(options);
        options.parse(argc, argv);
        if (answered(options, program)) return 0;
        settings.check(options);
        if (common.smooth) throw BadInput("--smooth: a thermal particle carries no stress that could be smoothed");
        scheme.printed = form == "printed";
        const Scene scene(settings);
        if (!options.given("t-end")) common.t_end = scene.default_t_end();
        common = common.with_period(scene.crossing_time());
        const std::string time = "time t [time]";
        const std::vector<Panel> panels{
            {"",
             "t",
             time,
             "temperature in the middle [temperature]",
             {{"T_mid", "computed", "lines dt solid lc rgb '#c03030'"}, {"T_mid_exact", "exact", "lines dt 2 lc rgb 'black'"}},
             ""},
            {"",
             "t",
             time,
             "heat [energy]",
             {{"heat", "stored", "lines dt solid lc rgb '#c03030'"}, {"heat_in", "flowed in", "lines dt 2 lc rgb 'black'"}},
             ""}};
        Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels};
        about.moves = false;
        return run_program(about, options, common, [&](int cells) {
            Assembled a;
            HeatShapes::with(common.shape, [&](auto kernel) { a = assemble_heat<decltype(kernel)>(scheme, scene, cells, common); });
            if (D == 2) a.animated.colour = common.colour, a.animated.colour_label = column_label(common.colour);
            return a;
        });
    });
}

}  // namespace mpm
