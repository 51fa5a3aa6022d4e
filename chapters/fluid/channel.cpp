/// channel: Couette and Poiseuille flow started from rest (the viscous stress of review 5.29), by MUSL, against the exact series.
///   ./channel --cells 8,16,32
///   ./channel --flow poiseuille --shape cubic --plot png
#include "chapters/fluid/channel.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "channel";
constexpr const char* purpose = "viscous flow between two plates, started from rest";
using LiquidShapes = ShapeList<Hat, Cubic>;

int run(int argc, char** argv) {
    Options options(program, purpose);
    ChannelSettings settings;
    Common common;
    common.cells = {16};
    common.ppc = 2;
    common.cfl = 0.2;
    common.records = 500;
    settings.declare(options);
    common.declare(options, LiquidShapes::names(), Channel{}.t_end, traits_of(Channel{}));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const Description about{program, purpose, Channel::name, Channel::solves, {Channel::columns.begin(), Channel::columns.end()}};
    return run_program(about, options, common, [&](int cells) {
        Assembled a;
        LiquidShapes::with(common.shape, [&](auto kernel) {
            a = assemble_with<decltype(kernel), false>(Musl{}, Channel(settings, cells, common.t_end), Flip{}, cells, common);
        });
        return a;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
