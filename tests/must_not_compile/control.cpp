// Control: with every piece whole the run compiles.
#include "tests/must_not_compile/pieces.hpp"

int main() { mpm::test::run<mpm::LinearElastic, mpm::FreeScene, mpm::Hat>({}); }
