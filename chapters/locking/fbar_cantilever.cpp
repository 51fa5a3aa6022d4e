/// fbar_cantilever: a nearly incompressible cantilever swings in gravity (review 5.2): low-order functions lock, F-bar (fbar.hpp) cures it.
///   ./fbar_cantilever --fbar off
///   ./fbar_cantilever --fbar grid --watch warn --plot png
#include "chapters/locking/fbar_cantilever/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "fbar_cantilever";
constexpr const char* purpose = "a nearly incompressible cantilever, with F-bar and without";
using Scene = SuddenCantilever<LockingLaw>;

std::vector<Panel> panels() {
    const std::string time = "time t [time]";
    return {{"",
             "t",
             time,
             "deflection of the tip [length]",
             {{"tip", "computed", "lines dt solid lc rgb '#c03030'"}, {"tip_static", "at rest, Timoshenko", "lines dt 2 lc rgb 'black'"}},
             ""},
            {"",
             "t",
             time,
             "pressure noise / rms pressure",
             {{"noise_within", "within cells", "lines dt solid lc rgb '#3060c0'"},
              {"noise_between", "from cell to cell", "lines dt 2 lc rgb '#c03030'"}},
             ""}};
}

void check(const FbarCantileverSettings& s) {
    if (s.scheme == "usl" && s.common.shape != "hat") throw BadInput("--shape " + s.common.shape + ": --scheme usl has the hat alone");
    if (s.scheme == "tlmpm" && s.common.shape == "ugimp") throw BadInput("--shape ugimp: --scheme tlmpm has hat and cubic alone");
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    FbarCantileverSettings s;
    s.common.cells = {16};
    s.common.ppc = 2;
    s.common.cfl = 0.3;
    s.common.records = 400;
    options.choice("scheme", s.scheme, {"musl", "usl", "tlmpm"}, "method");
    s.beam.declare(options);
    s.common.declare(options, {"hat", "ugimp", "cubic"}, 0.7 * s.beam.period(), traits_of(Scene(s.beam, 16)));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    check(s);
    s.beam.total = s.scheme == "tlmpm";
    if (!options.given("t-end")) s.common.t_end = 0.7 * s.beam.period();
    s.common = s.common.with_period(s.beam.period());
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels()};
    return run_program(about, options, s.common, [&](int cells) {
        if (s.scheme == "musl") return musl_cantilever(s, cells);
        return s.scheme == "usl" ? usl_cantilever(s, cells) : tlmpm_cantilever(s, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
