/// What one step costs: every explicit scheme with every shape, in 1D and 2D, beside the hand-written kernel of kernel.hpp, which is first
/// checked to give the same numbers. Counter `particle`: time per particle and step; compare ratios within one run.
///   g++ -std=c++20 -O3 -DNDEBUG -I. -I/usr/include/eigen3 tests/benchmarks/step.cpp lab/memory.cpp lab/strips.cpp lab/threads.cpp -fopenmp -lbenchmark
///   ./a.out --benchmark_filter='musl|kernel' --benchmark_enable_random_interleaving=true --benchmark_repetitions=9
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/point.hpp"
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/explicit/usf.hpp"
#include "chapters/explicit/usl.hpp"
#include "chapters/material/linear_elastic.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/weighting/bernstein.hpp"
#include "chapters/weighting/cpgimp.hpp"
#include "chapters/weighting/cubic.hpp"
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/quadratic.hpp"
#include "chapters/weighting/tensor.hpp"
#include "chapters/weighting/ugimp.hpp"
#include "lab/body.hpp"
#include "lab/boundary.hpp"
#include "lab/memory.hpp"
#include "tests/benchmarks/kernel.hpp"

namespace {

using namespace mpm;

constexpr int margin = 3;  // empty cells on each side of the body
constexpr double h = 0.7, dt = 0.2 * h;  // cell size; the wave speed is about 1
constexpr double slow = 1e-5, fast = 0.02;  // initial velocity of what is timed, and of the check

/// Each shape that is timed is one type here.
template <class... Kernel> struct List {};
using Shapes = List<Hat, Quadratic, Cubic, Ugimp, Cpgimp>;
using TotalLagrangianShapes = List<Bernstein>;
using Schemes = List<Usl, Usf, Musl, Tlmpm>;

/// What a scheme asks of its shape.
template <class Scheme, int D, class Kernel>
using ShapeOf = std::conditional_t<std::is_same_v<Scheme, Tlmpm>, Stored<Tensor<D, Kernel>>, Tensor<D, Kernel>>;
template <class Scheme, int D, class Law, class Kernel>
using BodyOf = Body<D, Point<D>, typename Scheme::template NodeOf<D>, Law, ShapeOf<Scheme, D, Kernel>, Flip>;

template <int D> Lattice<D> lattice_around(int cells, int per_cell) {
    std::array<int, D> all;
    all.fill(cells + 2 * margin);
    return {Vec<D>::Constant(-margin * h), Vec<D>::Constant(h), all, per_cell};
}

/// A free bar or square of `cells` cells along each axis, two particles per cell and axis, in cell order, in its first stretching mode.
template <class Scheme, int D, class Law, class Kernel> auto vibrating(int cells, double v0) {
    const auto lattice = lattice_around<D>(cells, Kernel::per_cell);
    Law law;
    law.lambda = 0.4, law.mu = 0.3;
    std::vector<Point<D>> points;
    reserve_large(points, static_cast<std::size_t>(power(cells, D) * power(2, D)));
    for (int cell = 0; cell < power(cells, D); ++cell)
        for (int k = 0; k < power(2, D); ++k) {
            Point<D> p;
            p.x[0] = h * (cell % cells + 0.25 + 0.5 * (k % 2));
            if constexpr (D == 2) p.x[1] = h * (cell / cells + 0.25 + 0.5 * (k / 2));
            p.X = p.x;
            p.m = p.V = p.V0 = std::pow(h / 2, D);
            const Vec<D> s = p.x / (h * cells);
            for (int d = 0; d < D; ++d) p.v[d] = -v0 * std::cos(M_PI * s[d]) * (1 + (D - 1) * 0.3 * std::sin(5 * s[D - 1 - d]));
            points.push_back(p);
        }
    Kernel kernel;
    if constexpr (requires { kernel.l; }) kernel.l = 0.5;
    if constexpr (requires { kernel.l0; }) kernel.l0 = 0.5;
    const Tensor<D, Kernel> shape{lattice, kernel};
    typename BodyOf<Scheme, D, Law, Kernel>::Shape used;
    if constexpr (std::is_same_v<Scheme, Tlmpm>)
        used = {shape, points};
    else
        used = shape;
    Grid<D, typename Scheme::template NodeOf<D>> grid(lattice);
    return std::array{BodyOf<Scheme, D, Law, Kernel>{{std::move(points), std::move(grid), law}, std::move(used), Flip{}}};
}

/// The same square for the hand-written kernel.
by_hand::Square by_hand_copy(const auto& body) {
    by_hand::Square s;
    const auto& lattice = body.grid.lattice();
    s.x0 = lattice.origin()[0], s.y0 = lattice.origin()[1], s.h = lattice.h()[0];
    s.cells_x = lattice.cells(0), s.cells_y = lattice.cells(1);
    s.lambda = body.law.lambda, s.mu = body.law.mu;
    s.nodes.resize(static_cast<std::size_t>(body.grid.size()));
    s.p.resize(body.points.size());
    for (std::size_t i = 0; i < body.points.size(); ++i) {
        const auto& p = body.points[i];
        s.p.m[i] = p.m, s.p.V0[i] = p.V0, s.p.V[i] = p.V;
        s.p.x[i] = p.x[0], s.p.y[i] = p.x[1], s.p.vx[i] = p.v[0], s.p.vy[i] = p.v[1];
        s.p.F00[i] = p.F(0, 0), s.p.F01[i] = p.F(0, 1), s.p.F10[i] = p.F(1, 0), s.p.F11[i] = p.F(1, 1);
        s.p.sxx[i] = p.sigma(0, 0), s.p.sxy[i] = p.sigma(0, 1), s.p.syy[i] = p.sigma(1, 1);
    }
    return s;
}

/// Cells along each axis for about `count` particles.
int cells_for(double count, int D) { return static_cast<int>(std::lround(D == 1 ? count / 2 : std::sqrt(count / 4))); }

/// Particles and threads of the benchmarks in two dimensions, named e.g. musl/hat/2d/linear/100000/threads:2/real_time.
void sizes_and_threads(benchmark::internal::Benchmark* b) {
    b->ArgNames({"", "threads"})->ArgsProduct({{1000, 10000, 100000, 1000000}, {1, 2}})->MeasureProcessCPUTime()->UseRealTime();
}

void report(benchmark::State& state, std::size_t particles) {
    using benchmark::Counter;
    state.counters["particle"] = Counter(static_cast<double>(particles), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

template <class Scheme, int D, class Law, class Kernel> void time_page(benchmark::State& state) {
    auto bodies = vibrating<Scheme, D, Law, Kernel>(cells_for(static_cast<double>(state.range(0)), D), slow);
    if constexpr (D == 2) bodies[0].grid.use_threads(static_cast<int>(state.range(1)));
    Scheme{}.step(bodies, Free{}, FreeScene{}, 0.0, dt);  // makes the buffers of several threads
    for (auto _ : state) {
        Scheme{}.step(bodies, Free{}, FreeScene{}, 0.0, dt);
        benchmark::ClobberMemory();
    }
    report(state, bodies[0].points.size());
}

/// Particles in random order, which are sorted by cell when that pays, or never.
template <bool sorted> void time_shuffled(benchmark::State& state) {
    auto bodies = vibrating<Musl, 2, LinearElastic, Hat>(cells_for(static_cast<double>(state.range(0)), 2), slow);
    auto& body = bodies[0];
    std::shuffle(body.points.begin(), body.points.end(), std::mt19937(1));
    body.grid.use_threads(static_cast<int>(state.range(1)));
    for (auto _ : state) {
        if constexpr (sorted) body.order.keep(body);
        Musl{}.step(bodies, Free{}, FreeScene{}, 0.0, dt);
        benchmark::ClobberMemory();
    }
    report(state, body.points.size());
}

template <class Law, class Kernel, auto step> void time_kernel(benchmark::State& state) {
    auto square = by_hand_copy(vibrating<Musl, 2, Law, Kernel>(cells_for(static_cast<double>(state.range(0)), 2), slow)[0]);
    square.threads = static_cast<int>(state.range(1));
    square.cut();
    step(square, dt);
    for (auto _ : state) {
        step(square, dt);
        benchmark::ClobberMemory();
    }
    report(state, square.p.x.size());
}

/// Ends the program if the page and the hand-written kernel differ after 60 steps in which particles change cells.
template <class Law, class Kernel, auto step> void check() {
    auto bodies = vibrating<Musl, 2, Law, Kernel>(20, fast);
    auto square = by_hand_copy(bodies[0]);
    for (int n = 0; n < 60; ++n) {
        Musl{}.step(bodies, Free{}, FreeScene{}, 0.0, dt);
        step(square, dt);
    }
    const auto expected = by_hand_copy(bodies[0]);
    double largest = 0;
    for (auto field : {&by_hand::Particles::x, &by_hand::Particles::y, &by_hand::Particles::vx, &by_hand::Particles::vy,
                       &by_hand::Particles::V, &by_hand::Particles::F00, &by_hand::Particles::F01, &by_hand::Particles::F10,
                       &by_hand::Particles::F11, &by_hand::Particles::sxx, &by_hand::Particles::sxy, &by_hand::Particles::syy})
        for (std::size_t i = 0; i < square.p.x.size(); ++i) {
            const double difference = std::abs((square.p.*field)[i] - (expected.p.*field)[i]);
            if (!(difference <= largest)) largest = difference;  // nan counts as different
        }
    if (largest <= 1e-12) return;
    std::fprintf(stderr, "step: the hand-written kernel and musl.hpp differ by %g (%s, %s); nothing was timed\n", largest, Kernel::name, Law::name);
    std::exit(1);
}

template <class Law, class Kernel, auto step> void add_kernel() {
    check<Law, Kernel, step>();
    const std::string name = std::string("kernel/") + Kernel::name + "/2d/" + Law::name;
    benchmark::RegisterBenchmark(name.c_str(), time_kernel<Law, Kernel, step>)->Apply(sizes_and_threads);
}

template <class Scheme, int D, class Law, class Kernel> void add() {
    const std::string name = std::string(Scheme::name) + "/" + Kernel::name + (D == 1 ? "/1d/" : "/2d/") + Law::name;
    auto* page = benchmark::RegisterBenchmark(name.c_str(), time_page<Scheme, D, Law, Kernel>);
    if constexpr (D == 2)
        page->Apply(sizes_and_threads);
    else
        page->RangeMultiplier(10)->Range(1000, 1000000);
}

template <class Law, class Kernel, class... Scheme> void add_schemes(List<Scheme...>) {
    (add<Scheme, 1, Law, Kernel>(), ...);
    (add<Scheme, 2, Law, Kernel>(), ...);
}

template <class Schemes, class... Kernel> void add_shapes(Schemes schemes, List<Kernel...>) {
    (add_schemes<LinearElastic, Kernel>(schemes), ...);
}
template <class... Kernel> void add_neo_hookean(List<Kernel...>) {
    (add<Musl, 2, NeoHookean, Kernel>(), ...);
}

}  // namespace

int main(int argc, char** argv) {
    using L = by_hand::Law;
    add_kernel<LinearElastic, Hat, by_hand::step_hat<L::linear_elastic>>();
    add_kernel<NeoHookean, Hat, by_hand::step_hat<L::neo_hookean>>();
    add_kernel<LinearElastic, Quadratic, by_hand::step_spline<L::linear_elastic, 3>>();
    add_kernel<NeoHookean, Quadratic, by_hand::step_spline<L::neo_hookean, 3>>();
    add_kernel<LinearElastic, Cubic, by_hand::step_spline<L::linear_elastic, 4>>();
    add_kernel<NeoHookean, Cubic, by_hand::step_spline<L::neo_hookean, 4>>();
    add_shapes(Schemes{}, Shapes{});
    add_shapes(List<Tlmpm>{}, TotalLagrangianShapes{});
    add_neo_hookean(Shapes{});
    benchmark::RegisterBenchmark("shuffled/hat/2d/linear", time_shuffled<false>)->Apply(sizes_and_threads);
    benchmark::RegisterBenchmark("shuffled_then_sorted/hat/2d/linear", time_shuffled<true>)->Apply(sizes_and_threads);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
}
