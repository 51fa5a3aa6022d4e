/// shock_tube: Sod's problem and any other Riemann problem of an ideal gas (review 6.1.4, figures 66 to 68) by MUSL, against the exact
/// solution at particles and nodes.
///   ./shock_tube --cells 300 --plot png
///   ./shock_tube --shape cpgimp --cells 100,200,400,800
/// Other problems (Toro): strong shock --p-left 1000 --rho-right 1 --p-right 0.01 --t-end 0.012; two rarefactions --u-left -2 --p-left 0.4
/// --rho-right 1 --u-right 2 --p-right 0.4 --t-end 0.15; into vacuum --rho-right 0.
#include <cmath>
#include <cstdio>
#include <memory>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/fluid/gas_profile.hpp"
#include "chapters/fluid/shock_tube.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "shock_tube";
constexpr const char* purpose = "the Riemann problem of an ideal gas in a tube";
using TubeShapes = ShapeList<Hat, Cpgimp, Cubic>;

template <class Kernel> WeightsAt weights_by(const Lattice<1>& lattice, int ppc) {
    return [shape = Tensor<1, Kernel>{lattice, sized<Kernel>(ppc)}](double x, double F) {
        Point<1> p;
        p.x[0] = x, p.F(0, 0) = F;
        std::vector<NodeWeight> all;
        for (const auto& entry : shape(p, 0)) all.push_back({entry.node, entry.phi});
        return all;
    };
}

/// Lets snapshots and errors show what the particles and nodes of a gas should be.
void compare_with_exact(Assembled& a, const ShockTube& tube, const WeightsAt& weights) {
    const auto t = std::make_shared<double>(0);
    const ExactTube exact{tube.exact(), tube.middle(), tube.gamma};
    a.simulation.sample = [t, sample = a.simulation.sample](double now, double energy) { *t = now, sample(now, energy); };
    const auto particles = [t, exact, plain = a.simulation.particles] { return with_exact(plain(), exact, *t); };
    const auto nodes = [t, exact, weights, particles = a.simulation.particles, grid = a.simulation.nodes] {
        return gas_on_nodes(particles(), weights, grid(), exact, *t);
    };
    a.errors = [particles, nodes](double) {
        std::vector<NamedError> all = gas_errors(nodes(), "", "_nodes");
        for (const NamedError& e : gas_errors(particles(), "V", "")) all.push_back(e);
        return all;
    };
    a.facts = [errors = a.errors, exact, nodes, particles](double t_end) {
        std::vector<std::pair<std::string, double>> all{{"pressure between the waves, exact", exact.solution.p_star()},
                                                        {"velocity between the waves, exact", exact.solution.u_star()}};
        const auto sum = [](const Snapshot& s, auto&& value) {
            double total = 0;
            for (std::size_t row = 0; row < s.rows(); ++row) total += value(s, row);
            return total;
        };
        const double on_nodes = sum(nodes(), [](const Snapshot& s, std::size_t row) { return s.at(row, s.find("m")); });
        const double of_gas = sum(particles(), [](const Snapshot& s, std::size_t row) {
            return s.at(row, s.find("V")) * s.at(row, s.find("rho"));
        });
        all.emplace_back("mass on the nodes / of the particles - 1", on_nodes / of_gas - 1);
        for (const auto& [name, value] : errors(t_end)) all.emplace_back("L1 error of " + name, value);
        return all;
    };
    a.simulation.particles = particles;
    a.simulation.nodes = nodes;
}

Assembled tube(const TubeSettings& settings, int cells, const Common& common) {
    const ShockTube scene(settings, cells, common.t_end);
    Assembled a;
    TubeShapes::with(common.shape, [&](auto kernel) {
        using Kernel = decltype(kernel);
        a = assemble_with<Kernel, false>(Musl{}, scene, Flip{}, cells, common);
        compare_with_exact(a, scene, weights_by<Kernel>(scene.lattice(cells, 1), common.ppc));
    });
    return a;
}

/// The four fields of the last snapshot of the nodes.
std::vector<Panel> panels(int frames) {
    char file[32];
    std::snprintf(file, sizeof file, "nodes_%04d.csv", frames);
    std::vector<Panel> all;
    if (frames == 0) return all;
    const std::vector<std::pair<std::string, std::string>> fields{{"rho", "density [mass/length]"},
                                                                  {"v", "velocity [length/time]"},
                                                                  {"p", "pressure [force]"},
                                                                  {"e", "internal energy [energy/mass]"}};
    for (const auto& [name, label] : fields)
        all.push_back({"", "x", "x [length]", label,
                       {{name + "_exact", "exact", "lines lc rgb 'black'"}, {name, "nodes", "points pt 7 ps 0.4 lc rgb '#c03030'"}},
                       "", file});
    return all;
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    TubeSettings settings;
    Common common;
    common.cells = {300};
    common.ppc = 3;
    common.records = 200;
    settings.declare(options);
    common.declare(options, TubeShapes::names(), ShockTube{}.t_end, traits_of(ShockTube{}));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    settings.check(common.t_end);
    if (!options.given("frames") && common.plot != "none") common.frames = common.plot == "gif" ? 50 : 1;
    const Description about{program, purpose, ShockTube::name, ShockTube::solves, {ShockTube::columns.begin(), ShockTube::columns.end()},
                            0, panels(common.frames)};
    return run_program(about, options, common, [&](int cells) { return tube(settings, cells, common); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
