// F-bar around a law in rate form, whose stress does not depend on F alone.
// must say: NoVelocityGradient
#include "chapters/locking/fbar.hpp"
#include "tests/must_not_compile/pieces.hpp"

int main() {
    mpm::test::Problem<2, mpm::Musl, mpm::Fbar<mpm::LinearElastic>> problem;
    problem.scheme.step(problem.bodies, mpm::Free{}, problem, 0, 0.1);
}
