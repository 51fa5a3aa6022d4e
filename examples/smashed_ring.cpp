/// smashed_ring: a ring on a rigid floor is crushed by a rigid platen (review 4.2.4, Algorithm 4, figure 40), by each updated-Lagrangian
/// scheme: force of platen and floor against the displacement, beside a curved beam's and the elastica's.
///   ./smashed_ring --frames 6 --plot gif
///   ./smashed_ring --cells 16,32,64 --t-end 20
#include "chapters/weighting/shapes.hpp"
#include "examples/smashed_ring/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "smashed_ring";
constexpr const char* purpose = "a ring crushed by a rigid platen";
constexpr double compression = 0.6;  // of the diameter, by default

std::vector<Panel> panels() {
    return {{"",
             "displacement",
             "displacement of the platen [length]",
             "force [force/length]",
             {{"force_platen", "platen", "lines dt solid lc rgb '#c03030'"},
              {"force_floor", "floor", "lines dt (8,3) lc rgb '#3050a0'"},
              {"force_elastica", "elastica", "lines dt solid lc rgb 'black'"},
              {"force_beam", "curved beam", "lines dt 2 lc rgb 'black'"}},
             ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    SmashedRingSettings s;
    s.common.cells = {32};
    s.common.ppc = 2;
    s.common.cfl = 0.3;
    s.common.records = 120;  // rows hold mean forces between them
    s.common.shape = "cubic";  // a wall of three cells bends badly with hat functions
    options.choice("scheme", s.scheme, {"usl", "usf", "musl"}, "method");
    options.number("alpha", s.alpha, "-", between(0, 1), "mix of FLIP (1) and PIC (0)");
    options.number("cutoff", s.cutoff, "mass", at_least(0), "nodes with at most this mass are left out (2.63); for --scheme usl");
    s.ring.declare(options);
    s.common.declare(options, UpdatedShapes::names(), s.ring.time_of(compression), traits_of(SmashedRing{}));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (!options.given("t-end")) s.common.t_end = s.ring.time_of(compression);
    if (s.cutoff > 0 && s.scheme != "usl") throw BadInput("--cutoff: only --scheme usl leaves nodes out, not " + s.scheme);
    using Scene = SmashedRing;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels()};
    return run_program(about, options, s.common, [&](int cells) {
        if (s.scheme == "usl") return usl_ring(s, cells);
        if (s.scheme == "usf") return usf_ring(s, cells);
        return musl_ring(s, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
