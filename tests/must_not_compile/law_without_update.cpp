// A constitutive model that does not say how the stress changes.
// must say: 'struct Rigid'} has no member named 'update'
#include "tests/must_not_compile/pieces.hpp"

struct Rigid {};

int main() { mpm::test::run<Rigid, mpm::FreeScene, mpm::Hat>({}); }
