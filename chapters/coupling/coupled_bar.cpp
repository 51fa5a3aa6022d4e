/// coupled_bar: a pulse crosses the joint of a bar of finite elements and a bar of particles, which are solved in one implicit system
/// (monolithic.hpp), against the exact wave; --bodies fem and --bodies mpm are the whole bar in one kind.
///   ./coupled_bar --cells 50,100,200
///   ./coupled_bar --contrast 4 --from mpm
#include "chapters/coupling/coupled.hpp"
#include "chapters/coupling/monolithic.hpp"
#include "chapters/scenes/glued_bar.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "coupled_bar";
constexpr const char* purpose = "a pulse crosses the joint of a finite element bar and an implicit MPM bar";

std::vector<Panel> panels() {
    const auto side = [](const std::string& name, const std::string& title) {
        return Panel{"", "t", "time t [time]", title,
                     {{name, "computed", "lines dt solid lc rgb '#c03030'"}, {name + "_exact", "exact", "lines dt 2 lc rgb 'black'"}}, ""};
    };
    return {side("momentum_left", "momentum of the left bar"), side("momentum_right", "momentum of the right bar")};
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    GluedBar bar;
    Common common;
    ImplicitOptions method;
    common.cells = {200};
    common.ppc = 2;
    common.cfl = 0.5;
    common.records = 200;
    method.tolerance = 1e-13;
    bar.declare(options);
    method.declare(options, false);
    common.declare(options, {LinearElement::name}, bar.t_end(), traits_of(bar));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (!options.given("t-end")) common.t_end = bar.t_end();
    for (const int cells : common.cells)
        if (cells % 2 != 0) throw BadInput("--cells " + std::to_string(cells) + ": an even number is allowed, for the joint is a node");
    const ImplicitSettings settings = coupled_settings(method, options, 1);
    const Description about{program, purpose, bar.name, bar.solves, {bar.columns.begin(), bar.columns.end()}, 0, panels()};
    return run_program(about, options, common, [&](int cells) {
        const std::string log = newton_path(program, options, common, cells, method);
        Assembled a = assemble_implicit<LinearElement, FemBody>(bar, settings, cells, common, log);
        if (common.t_end > bar.exact_until()) a.row.reference = "none";
        return a;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
