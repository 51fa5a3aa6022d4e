// A law that reads a temperature in a mechanical run.
// must say: 'struct mpm::Point<1>' has no member named 'T'
#include "tests/must_not_compile/pieces.hpp"

struct ThermoElastic : mpm::LinearElastic {
    template <class Point, class Gradient>
    void update(Point& p, const Gradient& L, double dt) const {
        mpm::LinearElastic::update(p, L, dt);
        p.sigma(0, 0) -= 1e-5 * p.T;
    }
};

int main() { mpm::test::run<ThermoElastic, mpm::FreeScene, mpm::Hat>({}); }
