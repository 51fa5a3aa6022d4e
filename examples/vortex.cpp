/// vortex: the generalized vortex (review 6.2.3), a ring sheared in circles as manufactured, by each scheme.
///   ./vortex --scheme tlmpm --shape bernstein --cells 25,50,100
/// As printed: --force nodes --boundary held --cut whole --start whole --alpha 0.99; --cfl is a part of the time that the fastest wave of
/// the sheared ring takes through a cell (vortex.hpp): 0.1 h/sqrt(E/rho) is --cfl 0.93 for --scheme tlmpm; --transfer fmpm wants half.
#include "examples/scheme_choice.hpp"
#include "examples/vortex/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "vortex";
constexpr const char* purpose = "convergence on the generalized vortex, a ring sheared in circles";

const std::vector<SchemeChoice<VortexSettings>> choices{{"usl", UpdatedShapes::names(), usl_vortex},
                                                        {"usf", UpdatedShapes::names(), usf_vortex},
                                                        {"musl", UpdatedShapes::names(), musl_vortex},
                                                        {"tlmpm", AllShapes::names(), tlmpm_vortex}};

int run(int argc, char** argv) {
    Options options(program, purpose);
    VortexSettings s;
    s.common.cells = {50};
    s.common.ppc = 2;
    s.common.cfl = 0.5;
    options.choice("scheme", s.scheme, scheme_names(choices), "method");
    options.choice("stress", s.stress, {"musl", "usl"},
                   "of --scheme tlmpm: velocities of the stress update mapped twice (musl) or not (usl)");
    s.scene.declare(options);
    s.transfer.declare(options);
    s.common.declare(options, AllShapes::names(), s.scene.T0, traits_of(Vortex<true>(s.scene)));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const auto& choice = chosen(choices, s.scheme, s.common.shape);
    check_settings(s);
    if (!options.given("t-end")) s.common.t_end = s.scene.T0;  // of this motion, not of the default one
    VortexSettings settings = s;
    settings.common = s.common.with_period(s.scene.period());
    using Scene = Vortex<true>;
    const double period = s.scene.period();
    Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, period};
    about.panels.push_back({"",
                            "t",
                            "time t [time]",
                            "angle of the middle circle [rad]",
                            {{"angle", "computed", "lines dt solid lc rgb '#c03030'"},
                             {"angle_exact", "exact", "lines dt 2 lc rgb 'black'"}},
                            ""});
    return run_program(about, options, settings.common, [&](int cells) { return choice.assemble(settings, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
