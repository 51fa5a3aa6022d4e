/// The `main` body of every program: options, one run for each resolution, files, report and exit code.
#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "lab/body.hpp"
#include "lab/boundary.hpp"
#include "lab/monitor.hpp"
#include "lab/norms.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/run.hpp"
#include "lab/table.hpp"

namespace mpm {

/// Options that every program has (DESIGN.md section 4).
struct Common {
    std::vector<int> cells{50};
    int ppc = 1;
    std::string shape = "hat";
    double cfl = 0.1, dt = 0, t_end = 0, periods = 0;
    std::string out, label, config, plot = "none", watch = "stop";
    int records = 4000, frames = 0, repeat = 1;
    bool quiet = false, dry_run = false;

    void declare(Options& o, const std::vector<std::string>& shapes, double default_t_end);
};

/// What a program needs of one assembled resolution besides the loop's view of it.
struct Assembled {
    Simulation simulation;
    SummaryRow row;                 // dimensions, sizes and names filled in
    std::function<std::vector<NamedError>(double t_end)> errors;
    std::function<std::vector<std::pair<std::string, double>>(double t_end)> facts;
    double critical_dt = 0;         // h/(c + |v|)
};

/// What a scene and a scheme say of themselves, for the screen.
struct Description {
    std::string program, purpose, scene, solves;
    std::vector<std::string> columns;
    double period = 0;
};

/// Runs every resolution and writes everything; returns the exit code.
int run_program(const Description& about, const Options& options, const Common& common,
                const std::function<Assembled(int cells)>& assemble);

/// Turns exceptions into one line on stderr and the exit code of the contract.
int guarded(const std::string& program, const std::function<int()>& main_body);
/// Answers --help, --version and --describe; true if one was asked for.
bool answered(const Options& options, const std::string& program);

/// Joins one scheme, one scene, one shape and one transfer into what the loop runs.
template <class Scheme, class Scene, class Shape, class Transfer, class MakeShape>
Assembled assemble(const Scheme& scheme, const Scene& scene, const Transfer& transfer, int cells, const Common& common,
                   MakeShape&& make_shape) {
    constexpr int D = Scene::D;
    using Point = typename Scheme::template PointOf<D>;
    using Node = typename Scheme::template NodeOf<D>;
    using OneBody = Body<D, Point, Node, typename Scene::Law, Shape>;
    using Kernel = typename Shape::Kernel;
    struct State {
        Scheme scheme;
        Scene scene;
        Transfer transfer;
        std::vector<OneBody> bodies;
        std::vector<std::vector<Point>> good;
        typename Scene::Observer observer;
        State(const Scheme& a, const Scene& b, const Transfer& c) : scheme(a), scene(b), transfer(c), observer{scene} {}
    };
    auto s = std::make_shared<State>(scheme, scene, transfer);
    const Lattice<D> lattice = scene.lattice(cells, Kernel::per_cell);
    auto points = scene.template particles<Point>(cells, common.ppc);
    Shape shape = make_shape(lattice, points);
    s->bodies.push_back(OneBody{points, Grid<D, Node>(lattice), scene.law(), std::move(shape)});

    Assembled a;
    a.critical_dt = critical_step<D>(lattice.h(), scene.law().wave_speed(), scene.speed());
    a.row.scene = Scene::name;
    a.row.scheme = Scheme::name;
    a.row.shape = Kernel::name;
    a.row.transfer = Transfer::name;
    a.row.dim = D;
    a.row.cells = cells;
    a.row.h = lattice.h()[0];
    a.row.ppc = common.ppc;
    a.row.particles = static_cast<long>(points.size());
    a.row.bytes_per_particle = sizeof(Point);
    a.row.bytes_per_node = sizeof(Node);
    a.errors = [s](double t_end) { return s->observer.errors(t_end); };
    a.facts = [s](double t_end) { return s->observer.facts(t_end); };
    const double t_end = common.t_end;
    Simulation& sim = a.simulation;
    sim.step = [s](double t, double dt) { s->scheme.step(s->bodies, s->transfer, Free{}, s->scene, t, dt); };
    sim.measure = [s] { return measure(s->bodies); };
    sim.check = [s] { return check_particles(s->bodies); };
    sim.sample = [s](double t, double energy) { s->observer.sample(s->bodies[0].points, t, energy); };
    sim.wants_energy = [s, t_end](double t) { return s->observer.wants_energy(t, t_end); };
    sim.watch = [s](double t) {
        const auto values = s->scene.watch(s->bodies[0].points, t);
        return std::vector<double>(values.begin(), values.end());
    };
    sim.keep = [s] {
        s->good.clear();
        for (const auto& body : s->bodies) s->good.push_back(body.points);
    };
    sim.restore = [s] {
        for (std::size_t b = 0; b < s->good.size(); ++b) s->bodies[b].points = s->good[b];
    };
    sim.keep();
    sim.write_particles = [s](const std::string& path) { write_particles(path, s->bodies); };
    sim.write_nodes = [s](const std::string& path) { write_nodes(path, s->bodies); };
    return a;
}

/// Snapshots: position, velocity, stress of every particle; position, mass, momentum of every node.
template <class Bodies> void write_particles(const std::string& path, const Bodies& bodies) {
    constexpr int D = Bodies::value_type::D;
    CsvFile file(path, D == 1 ? std::vector<std::string>{"body", "x", "v", "F", "sigma", "V"}
                              : std::vector<std::string>{"body", "x", "y", "vx", "vy", "sxx", "syy", "sxy", "J", "V"});
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (const auto& p : bodies[b].points) {
            std::vector<double> r{static_cast<double>(b)};
            if constexpr (D == 1)
                r.insert(r.end(), {p.x[0], p.v[0], p.F(0, 0), p.sigma(0, 0), p.V});
            else
                r.insert(r.end(), {p.x[0], p.x[1], p.v[0], p.v[1], p.sigma(0, 0), p.sigma(1, 1), p.sigma(0, 1), p.V / p.V0, p.V});
            file.row(r.data(), r.size());
        }
}
template <class Bodies> void write_nodes(const std::string& path, const Bodies& bodies) {
    constexpr int D = Bodies::value_type::D;
    CsvFile file(path, D == 1 ? std::vector<std::string>{"body", "x", "m", "mv"} : std::vector<std::string>{"body", "x", "y", "m", "mvx", "mvy"});
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (int I = 0; I < bodies[b].grid.size(); ++I) {
            const auto& node = bodies[b].grid[I];
            const Vec<D> x = bodies[b].grid.lattice().position(I);
            std::vector<double> r{static_cast<double>(b), x[0]};
            if constexpr (D == 2) r.push_back(x[1]);
            r.push_back(node.m);
            for (int d = 0; d < D; ++d) r.push_back(node.mv_new[d]);
            file.row(r.data(), r.size());
        }
}

}  // namespace mpm
