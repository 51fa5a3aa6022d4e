/// flying_bar: a bar flies freely, however small it is, or into a wall, slower or faster than sound; by each scheme.
///   ./flying_bar --mach 0.5 --cells 50,100,200
///   ./flying_bar --into nothing --size 0.5 --mach 0.01 --strain 1e-4 --cells 20
#include "examples/flying_bar/settings.hpp"
#include "examples/scheme_choice.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "flying_bar";
constexpr const char* purpose = "a bar flies freely or into a wall";

const std::vector<SchemeChoice<FlyingSettings>> choices{{"usl", FlyingShapes::names(), usl_flying},
                                                        {"usf", FlyingShapes::names(), usf_flying},
                                                        {"musl", FlyingShapes::names(), musl_flying},
                                                        {"tlmpm", FlyingShapes::names(), tlmpm_flying},
                                                        {"impm", {Hat::name}, impm_flying},
                                                        {"cpdi", {Hat::name}, cpdi_flying}};

int run(int argc, char** argv) {
    Options options(program, purpose);
    FlyingSettings s;
    s.common.cells = {50};
    s.common.ppc = 2;
    options.choice("scheme", s.scheme, scheme_names(choices), "method; cpdi: CPDI-L2 by USL");
    s.scene.declare(options);
    s.transfer.declare(options);
    s.common.declare(options, FlyingShapes::names(), FlyingBar<false>(s.scene, 50).default_t_end());
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const auto& choice = chosen(choices, s.scheme, s.common.shape);
    s.transfer.check(s.common.ppc);
    s.scene.check(options);
    if (s.transfer.name != "flip" && s.scheme != "tlmpm")
        throw BadInput("--transfer " + s.transfer.name + ": allowed with --scheme tlmpm, not " + s.scheme);
    if (s.scheme == "cpdi" && s.transfer.alpha != 1) throw BadInput("--alpha: --scheme cpdi has FLIP alone");
    if (!s.scene.strikes() && !options.given("t-end")) {
        if (s.common.cells.size() > 1) throw BadInput("--into nothing: the end of the run depends on h; one number of --cells is allowed");
    }
    if (!options.given("t-end")) s.common.t_end = FlyingBar<false>(s.scene, s.common.cells.front()).default_t_end();
    const Panel velocity{"",
                         "t",
                         "time t [time]",
                         "mean velocity [length/time]",
                         {{"v_cm", "computed", "lines dt solid lc rgb '#c03030'"}, {"v_cm_exact", "exact", "lines dt 2 lc rgb 'black'"}},
                         ""};
    using Scene = FlyingBar<false>;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, {velocity}};
    return run_program(about, options, s.common, [&](int cells) { return choice.assemble(s, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
