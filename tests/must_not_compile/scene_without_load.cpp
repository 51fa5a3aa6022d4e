// A scene that forgets its loads.
// must say: 'const struct Held' has no member named 'load'
#include "tests/must_not_compile/pieces.hpp"

struct Held {
    template <class Grid, class Field>
    void fix(Grid&, Field, double) const {}
};

int main() { mpm::test::run<mpm::LinearElastic, Held, mpm::Hat>({}); }
