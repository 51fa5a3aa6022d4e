/// mms_square: convergence on the manufactured unit square (review 6.2.2 in plane strain) of the MPM schemes, side by side.
///   ./mms_square --scheme tlmpm --shape cubic --G 0.05 --cells 8,16,32,64
/// The time step is a fraction of h/(c_P + |v|); the review's 0.2 h/sqrt(E/rho) is --cfl 0.2325 for nu = 0.3 and small G, 0.2765 for
/// G = 0.05. As printed: --force nodes --alpha 0.99.
#include "examples/mms_square/settings.hpp"
#include "lab/traits.hpp"
#include "examples/scheme_choice.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "mms_square";
constexpr const char* purpose = "convergence on a manufactured vibration of a unit square";

const std::vector<SchemeChoice<SquareSettings>> choices{{"usl", UpdatedShapes::names(), usl_square},
                                                        {"usf", UpdatedShapes::names(), usf_square},
                                                        {"musl", UpdatedShapes::names(), musl_square},
                                                        {"tlmpm", AllShapes::names(), tlmpm_square},
                                                        {"impm", {Hat::name}, impm_square}};

int run(int argc, char** argv) {
    Options options(program, purpose);
    SquareSettings s;
    s.common.cells = {32};
    s.common.ppc = 2;
    s.common.cfl = 0.2;
    options.choice("scheme", s.scheme, scheme_names(choices), "method");
    options.choice("stress", s.stress, {"musl", "usl"},
                   "of --scheme tlmpm: velocities of the stress update mapped twice (musl) or not (usl)");
    s.scene.declare(options);
    s.transfer.declare(options);
    s.impm.declare(options, 2, "of --scheme impm: ");
    s.common.declare(options, AllShapes::names(), s.scene.period(), traits_of(Square<true>(s.scene)));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const auto& choice = chosen(choices, s.scheme, s.common.shape);
    check_settings(s);
    if (s.scheme != "impm" && !s.impm.changed().empty())
        throw BadInput("--" + s.impm.changed() + ": only --scheme impm has it, not " + s.scheme);
    if (s.scheme == "impm" && !options.given("force")) s.scene.force.at = "nodes";  // the mass of its nodes is not made of m_p
    const double period = s.scene.period();
    if (!options.given("t-end")) s.common.t_end = period;  // one period of this motion, not of the default one
    SquareSettings settings = s;
    settings.common = s.common.with_period(period);
    using Scene = Square<true>;
    Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, period};
    for (const std::string axis : {"x", "y"})
        about.panels.push_back({"",
                                "t",
                                "time t [time]",
                                "v_{cm," + axis + "} [length/time]",
                                {{"v_cm_" + axis, "computed", "lines dt solid lc rgb '#c03030'"},
                                 {"v_cm_" + axis + "_exact", "exact", "lines dt 2 lc rgb 'black'"}},
                                ""});
    return run_program(about, options, settings.common, [&](int cells) { return choice.assemble(settings, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
