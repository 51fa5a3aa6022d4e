/// cpdi_vortex: the generalized vortex (review 6.2.3, figures 72 and 73) by CPDI with domains that follow the ring's edges, or boxes.
/// A shear of 6 makes domains of half a cell (--ppc 2) as long as three cells, beyond which corners miss cells between them; boxes at the
/// edges, half of them where the grid is held at rest, come there with any --ppc: --watch warn lets them go on.
///   ./cpdi_vortex --shape cpdi-q4 --domains conforming --cells 50,100
///   ./cpdi_vortex --shape cpdi-r4 --domains boxes --ppc 2 --watch warn --frames 2
#include "chapters/cpdi/vortex_of_domains.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "lab/program.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "cpdi_vortex";
constexpr const char* purpose = "the generalized vortex, a ring sheared in circles, by CPDI";

struct Settings {
    Common common;
    VortexCase ring;
    std::string domains = "conforming";
    double alpha = 1;
};

/// Throws BadInput for what does not go together.
void check(const Settings& s) {
    s.ring.check();
    if (s.domains == "conforming" && s.common.shape == DomainR4::name)
        throw BadInput("--domains conforming with --shape cpdi-r4: polar domains are no rectangles; allowed: cpdi-q4");
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    Settings s;
    s.common.cells = {50};
    s.common.ppc = 3;
    s.common.cfl = 0.5;
    s.common.shape = DomainQ4::name;
    s.ring.declare(options);
    options.choice("domains", s.domains, {"conforming", "boxes"}, "polar domains up to the ring's edges, or boxes with middles inside");
    options.number("alpha", s.alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0)");
    s.common.declare(options, {DomainR4::name, DomainQ4::name}, s.ring.T0, traits_of(Vortex<false>(s.ring)));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    check(s);
    if (!options.given("t-end")) s.common.t_end = s.ring.T0;
    s.common = s.common.with_period(s.ring.period());
    const VortexOfDomains scene(s.ring, s.domains == "conforming");
    using Scene = VortexOfDomains;
    Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, s.ring.period()};
    about.panels.push_back({"",
                            "t",
                            "time t [time]",
                            "angle of the middle circle [rad]",
                            {{"angle", "computed", "lines dt solid lc rgb '#c03030'"},
                             {"angle_exact", "exact", "lines dt 2 lc rgb 'black'"}},
                            ""});
    return run_program(about, options, s.common,
                       [&](int cells) { return assemble_domains<false>(Musl{}, scene, Flip{s.alpha}, cells, s.common); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
