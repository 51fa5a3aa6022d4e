// A scene that forgets its Dirichlet conditions.
// must say: 'const struct Thrown' has no member named 'fix'
#include "tests/must_not_compile/pieces.hpp"

struct Thrown {
    template <class Body>
    void load(Body&, double) const {}
};

int main() { mpm::test::run<mpm::LinearElastic, Thrown, mpm::Hat>({}); }
