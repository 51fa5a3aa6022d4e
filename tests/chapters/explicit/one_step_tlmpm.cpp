#include "tests/chapters/explicit/one_step.hpp"

namespace mpm::test {
INSTANTIATE_TYPED_TEST_SUITE_P(tlmpm, OneStep, Tlmpm);
}
