/// hydrostatic: a column of weakly compressible liquid at rest (review 5.4.1) by MUSL, its pressure against rho g h.
///   ./hydrostatic --plot png
///   ./hydrostatic --start sudden --shape cubic --cells 10,20,40
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/fluid/hydrostatic.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "hydrostatic";
constexpr const char* purpose = "a column of weakly compressible liquid at rest";
using LiquidShapes = ShapeList<Hat, Cubic>;

int run(int argc, char** argv) {
    Options options(program, purpose);
    HydrostaticSettings settings;
    Common common;
    common.cells = {20};
    common.ppc = 2;
    common.cfl = 0.3;
    common.records = 1000;
    settings.declare(options);
    common.declare(options, LiquidShapes::names(), 0.5, traits_of(Hydrostatic{}));
    common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const double period = settings.period();
    const Description about{
        program, purpose, Hydrostatic::name, Hydrostatic::solves, {Hydrostatic::columns.begin(), Hydrostatic::columns.end()}, period};
    return run_program(about, options, common.with_period(period), [&](int cells) {
        Assembled a;
        LiquidShapes::with(common.shape, [&](auto kernel) {
            a = assemble_with<decltype(kernel), false>(Musl{}, Hydrostatic(settings, cells), Flip{}, cells, common.with_period(period));
        });
        return a;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
