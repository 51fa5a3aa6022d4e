/// mms_segment: convergence on the manufactured unit segment (review 6.2.1) of the MPM schemes and of finite elements, side by side.
///   ./mms_segment --scheme usl --shape cpgimp --G 0.05 --cells 16,32,64,128
/// The time step is a fraction of h/(c_P + |v|); the review's 0.2 h/sqrt(E/rho) is --cfl 0.232 for nu = 0.3 and small G.
#include <algorithm>

#include "chapters/weighting/shapes.hpp"
#include "examples/mms_segment/settings.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "mms_segment";
constexpr const char* purpose = "convergence on a manufactured vibration of a unit segment";

struct Choice {
    const char* name;
    std::vector<std::string> shapes;
    Assembled (*assemble)(const SegmentSettings&, int cells);
};
const std::vector<Choice> choices{{"usl", UpdatedShapes::names(), usl_segment},
                                  {"usf", UpdatedShapes::names(), usf_segment},
                                  {"musl", UpdatedShapes::names(), musl_segment},
                                  {"tlmpm", AllShapes::names(), tlmpm_segment},
                                  {"impm", {Hat::name}, impm_segment},
                                  {"fem", ElementShapes::names(), fem_segment}};

/// What the scheme cannot do with the options, each by itself allowed. Throws BadInput.
void check(const Options& options, SegmentSettings& s, const Choice& choice) {
    const std::string shape = "--shape " + s.common.shape, scheme = "--scheme " + s.scheme;
    const bool elements = s.scheme == "fem", gimp = s.common.shape == Ugimp::name || s.common.shape == Cpgimp::name;
    if (std::find(choice.shapes.begin(), choice.shapes.end(), s.common.shape) == choice.shapes.end()) {
        std::string names;
        for (const std::string& name : choice.shapes) names += (names.empty() ? "" : ", ") + name;
        throw BadInput(shape + ": allowed with " + scheme + ": " + names);
    }
    if (s.formulation != "total" && !elements) throw BadInput("--formulation: only --scheme fem has one, not " + s.scheme);
    if (elements && (s.transfer.name != "flip" || s.transfer.alpha != 1))
        throw BadInput("--transfer, --alpha: --scheme fem has no particles to carry velocities");
    if (s.stress != "musl" && s.scheme != "tlmpm") throw BadInput("--stress: only --scheme tlmpm has two flavours, not " + s.scheme);
    s.transfer.check(s.common.ppc);
    if (s.scheme == "impm") {
        if (s.transfer.name != "flip")
            throw BadInput("--transfer " + s.transfer.name + ": --scheme impm fits velocities itself; allowed: flip");
        if (!options.given("force")) s.scene.force = "nodes";  // the mass of its nodes is not made of m_p
    } else if (const std::string name = s.impm.changed(); !name.empty()) {
        throw BadInput("--" + name + ": only --scheme impm has it, not " + s.scheme);
    }
    if (elements && options.given("points") && s.scene.placing != "gauss") throw BadInput("--points mid: " + scheme + " has Gauss points");
    if (elements) s.scene.placing = "gauss";
    if (gimp && s.scene.placing == "gauss" && s.common.ppc > 2)
        throw BadInput("--points gauss with " + shape + ": particles of one size tile a cell only with --ppc 1 or 2");
    if (s.common.shape == Lagrange2::name && s.common.ppc < 2)
        throw BadInput("--ppc 1 with " + shape + ": one point leaves the end nodes of quadratic elements without mass; allowed >= 2");
    s.scene.check();
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    SegmentSettings s;
    std::vector<std::string> schemes, shapes = AllShapes::names();
    for (const Choice& choice : choices) schemes.emplace_back(choice.name);
    shapes.emplace_back(Lagrange2::name);
    s.common.cells = {64};
    s.common.cfl = 0.2;
    options.choice("scheme", s.scheme, schemes, "method");
    options.choice("formulation", s.formulation, {"total", "updated"}, "of --scheme fem: on the initial configuration or the moved mesh");
    options.choice("stress", s.stress, {"musl", "usl"}, "of --scheme tlmpm: velocities of the stress update mapped twice (musl) or not (usl)");
    s.scene.declare(options);
    s.transfer.declare(options);
    s.impm.declare(options, 1, "of --scheme impm: ");
    s.common.declare(options, shapes, s.scene.period(), {.period = true});
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const Choice& choice = *std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.name == s.scheme; });
    check(options, s, choice);
    const auto& scene = s.scene;
    if (!options.given("t-end")) s.common.t_end = scene.period();  // one period of this motion, not of the default one
    SegmentSettings chosen = s;
    chosen.common = s.common.with_period(scene.period());
    const Description about{program, purpose, scene.name, scene.solves, {scene.columns.begin(), scene.columns.end()}, scene.period()};
    return run_program(about, options, chosen.common, [&](int cells) { return choice.assemble(chosen, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
