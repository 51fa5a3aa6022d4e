/// two_disks: two elastic disks meet and rebound (review 6.1.2, figures 60 to 62), by each scheme. Contact comes free with the one velocity
/// field of updated-Lagrangian schemes, up to a cell too early; total-Lagrangian ones have none and end when the disks lie in each other.
///   ./two_disks --scheme musl --plot gif
///   ./two_disks --scheme musl --cells 20,40,80,160
#include <algorithm>

#include "chapters/weighting/shapes.hpp"
#include "examples/two_disks/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "two_disks";
constexpr const char* purpose = "two elastic disks meet and rebound";

void check(const TwoDisksSettings& s) {
    s.transfer.check(s.common.ppc);
    const std::vector<std::string> updated = UpdatedShapes::names();
    if (s.scheme != "tlmpm" && std::find(updated.begin(), updated.end(), s.common.shape) == updated.end())
        throw BadInput("--shape " + s.common.shape + ": allowed with --scheme tlmpm only, its particles never leave their cells");
    if (s.cutoff > 0 && s.scheme != "usl") throw BadInput("--cutoff: only --scheme usl leaves nodes out, not " + s.scheme);
}

std::vector<Panel> panels() {
    return {{"",
             "t",
             "time t [time]",
             "distance of centres [length]",
             {{"approach", "computed", "lines dt solid lc rgb '#c03030'"}, {"approach_exact", "until they touch", "lines dt 2 lc rgb 'black'"}},
             ""}};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    TwoDisksSettings s;
    s.common.cells = {20};
    s.common.ppc = 2;
    options.choice("scheme", s.scheme, {"usl", "usf", "musl", "tlmpm"}, "method");
    options.number("cutoff", s.cutoff, "mass", at_least(0), "nodes with at most this mass are left out (2.63); for --scheme usl");
    s.disks.declare(options);
    s.transfer.declare(options);
    s.common.declare(options, AllShapes::names(), 3.5, traits_of(TwoDisks<false>{}));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    check(s);
    using Scene = TwoDisks<false>;
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, panels()};
    return run_program(about, options, s.common, [&](int cells) {
        if (s.scheme == "usl") return usl_disks(s, cells);
        if (s.scheme == "usf") return usf_disks(s, cells);
        if (s.scheme == "musl") return musl_disks(s, cells);
        return tlmpm_disks(s, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
