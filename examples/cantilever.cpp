/// cantilever: the beam of implicit_cantilever, which bends under its weight and is then left to swing, by explicit schemes with the same
/// particles.
///   ./cantilever --cells 16,32
///   ./cantilever --contrast 100 --scheme musl --rows 10 --layers 5
#include "examples/cantilever/settings.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "cantilever";
constexpr const char* purpose = "a short beam swings by explicit schemes";

int run(int argc, char** argv) {
    Options options(program, purpose);
    CantileverSettings s;
    s.common.cells = {16};
    s.common.shape = "cubic";
    s.common.cfl = 0.4;
    s.common.records = 1000;
    options.choice("scheme", s.scheme, {"tlmpm", "musl"}, "method");
    s.beam.declare(options);
    s.common.declare(options, {"hat", "cubic"}, 8, traits_of(s.beam));
    s.common.declare_threads(options);
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (options.given("ppc")) throw BadInput("--ppc: --rows and --layers say how many particles there are");
    const auto& beam = s.beam;
    const Description about{program, purpose, beam.name, beam.solves, {beam.columns.begin(), beam.columns.end()}};
    return run_program(about, options, s.common, [&](int cells) {
        return s.scheme == "musl" ? musl_cantilever(s, cells) : tlmpm_cantilever(s, cells);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
