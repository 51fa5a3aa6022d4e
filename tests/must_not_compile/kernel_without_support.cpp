// A weighting function that does not say how many nodes it touches.
// must say: 'support' is not a member of 'mpm::Tensor<1, Endless>
#include "tests/must_not_compile/pieces.hpp"

struct Endless {
    static constexpr const char* name = "endless";
    static constexpr int min_cells = 1, per_cell = 1;
    mpm::AxisWeights<2> operator()(double, int) const { return {}; }
};

int main() { mpm::test::run<mpm::LinearElastic, mpm::FreeScene, Endless>({}); }
