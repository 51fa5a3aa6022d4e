#include "examples/mms_square/tlmpm.hpp"

namespace mpm {

template Assembled total_square(const SquareSettings&, const Apic<true>&, int);
template Assembled total_square(const SquareSettings&, const Consistent<true>&, int);

}  // namespace mpm
