/// affine_motion: a square is stretched, compressed or sheared homogeneously by its edges, as far as one likes; by each scheme.
///   ./affine_motion --motion stretch --amount 10 --scheme musl --shape cubic
///   ./affine_motion --motion compress --amount 0.02
#include "examples/affine_motion/settings.hpp"
#include "examples/scheme_choice.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "affine_motion";
constexpr const char* purpose = "homogeneous deformation, as large as one likes";

const std::vector<SchemeChoice<AffineSettings>> choices{{"usl", AffineShapes::names(), usl_affine},
                                                        {"usf", AffineShapes::names(), usf_affine},
                                                        {"musl", AffineShapes::names(), musl_affine},
                                                        {"tlmpm", AffineShapes::names(), tlmpm_affine},
                                                        {"impm", {Hat::name}, impm_affine},
                                                        {"cpdi", {Hat::name}, cpdi_affine}};

int run(int argc, char** argv) {
    Options options(program, purpose);
    AffineSettings s;
    s.common.cells = {8};
    s.common.ppc = 2;
    options.choice("scheme", s.scheme, scheme_names(choices), "method; cpdi: quadrilaterals (CPDI-Q4) by MUSL");
    s.scene.declare(options);
    s.transfer.declare(options);
    s.common.declare(options, AffineShapes::names(), s.scene.T(), traits_of(Affine<true>(s.scene, 1)));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const auto& choice = chosen(choices, s.scheme, s.common.shape);
    check_settings(s);
    for (const char* transfer : {"xpic", "consistent"})
        if (s.transfer.name == transfer) throw BadInput(std::string("--transfer ") + transfer + ": allowed here: flip, apic, fmpm");
    if (s.scheme == "cpdi" && s.scene.placing == "gauss")
        throw BadInput("--points gauss: domains lie around their particles, allowed: mid");
    if (!options.given("t-end")) s.common.t_end = s.scene.T();
    using Scene = Affine<true>;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}};
    return run_program(about, options, s.common, [&](int cells) { return choice.assemble(s, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
