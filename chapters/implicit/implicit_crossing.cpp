/// implicit_crossing: a free bar flies through a thousand cells and vibrates: what implicit MPM gains or loses where particles change
/// cells, by what particles carry and by the smoothness of the functions.
///   ./implicit_crossing --carry particle --beta 0.25
///   ./implicit_crossing --carry midpoint --shape quadratic
#include "chapters/implicit/crossing.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "implicit_crossing";
constexpr const char* purpose = "a free bar flies through the grid by implicit MPM";

int run(int argc, char** argv) {
    Options options(program, purpose);
    CrossingSettings s;
    s.common.cells = {20};
    s.common.ppc = 2;
    s.common.cfl = 1;
    s.bar.declare(options);
    s.method.declare(options, false);
    s.common.declare(options, {LinearElement::name, QuadraticElement::name, QuadraticSpline::name, CubicSpline::name}, 1);
    options.contradict("t-end", "crossings");
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (s.common.cells.size() > 1 && !options.given("t-end"))
        throw BadInput("--cells: one number, or --t-end with it, for the bar flies by --crossings cells");
    if (options.given("t-end")) s.bar.crossings = std::ceil(s.common.t_end * s.bar.speed_ / s.bar.h(s.common.cells[0]));
    else s.common.t_end = s.bar.t_end(s.common.cells[0]);
    s.settings = s.method.settings(options, 1);
    using Scene = FreeBar;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}};
    return run_program(about, options, s.common, [&](int cells) {
        const std::string log = newton_path(program, options, s.common, cells, s.method);
        if (s.common.shape == LinearElement::name) return fly<LinearElement>(s, cells, log);
        if (s.common.shape == QuadraticElement::name) return fly<QuadraticElement>(s, cells, log);
        if (s.common.shape == QuadraticSpline::name) return fly<QuadraticSpline>(s, cells, log);
        return fly<CubicSpline>(s, cells, log);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
