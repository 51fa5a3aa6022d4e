/// fbar_block: Cook's membrane of a nearly incompressible solid (review 5.2), its pressure with F-bar (fbar.hpp) and without.
///   ./fbar_block --fbar off --plot png
///   ./fbar_block --scheme tlmpm --cells 8,16 --plot png
#include "chapters/locking/fbar_block/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "fbar_block";
constexpr const char* purpose = "a nearly incompressible tapered panel, with F-bar and without";
using Scene = Cook<Fbar<NeoHookean>>;

std::vector<Panel> panels() {
    const std::string time = "time t [time]";
    return {{"", "t", time, "displacement of the loaded side [length]", {{"tip", "computed", "lines dt solid lc rgb '#c03030'"}}, ""},
            {"",
             "t",
             time,
             "pressure noise / rms pressure",
             {{"noise_within", "within cells", "lines dt solid lc rgb '#3060c0'"},
              {"noise_between", "from cell to cell", "lines dt 2 lc rgb '#c03030'"}},
             ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    FbarBlockSettings s;
    s.common.cells = {16};
    s.common.ppc = 2;
    s.common.cfl = 0.3;
    s.common.records = 400;
    options.choice("scheme", s.scheme, {"musl", "tlmpm"}, "method");
    s.cook.declare(options);
    s.common.declare(options, {"hat", "ugimp"}, s.cook.time_to_peak(), traits_of(Scene(s.cook, 16, 2)));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (s.scheme == "tlmpm" && s.common.shape == "ugimp") throw BadInput("--shape ugimp: --scheme tlmpm has the hat alone");
    s.cook.total = s.scheme == "tlmpm";
    if (!options.given("t-end")) s.common.t_end = s.cook.time_to_peak();
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels()};
    return run_program(about, options, s.common,
                       [&](int cells) { return s.scheme == "musl" ? musl_block(s, cells) : tlmpm_block(s, cells); });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
