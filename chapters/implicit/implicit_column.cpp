/// implicit_column: a column sinks under its weight and a load until it rests, in a few large steps of a damped Newmark rule (dynamic
/// relaxation), against its exact state of rest.
///   ./implicit_column --cells 10,20,40,80
///   ./implicit_column --g 0 --traction -2e5 --gamma 0.6
#include "chapters/implicit/program.hpp"
#include "chapters/scenes/resting_column.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "implicit_column";
constexpr const char* purpose = "a column comes to rest under weight and load by large implicit steps";

int run(int argc, char** argv) {
    Options options(program, purpose);
    RestingColumn column;
    Common common;
    ImplicitOptions method;
    common.cells = {20};
    common.ppc = 2;
    common.cfl = 20;
    method.gamma = 1;
    column.declare(options);
    method.declare(options, false);
    common.declare(options, {LinearElement::name, QuadraticElement::name}, 2, traits_of(column));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (!options.given("beta")) method.beta = (method.gamma + 0.5) * (method.gamma + 0.5) / 4;  // damps the fastest waves most
    const ImplicitSettings settings = method.settings(options, 1);
    column.at_rest();
    const Description about{program, purpose, column.name, column.solves, {column.columns.begin(), column.columns.end()}};
    return run_program(about, options, common, [&](int cells) {
        const std::string log = newton_path(program, options, common, cells, method);
        if (common.shape == LinearElement::name) return assemble_implicit<LinearElement>(column, settings, cells, common, log);
        return assemble_implicit<QuadraticElement>(column, settings, cells, common, log);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
