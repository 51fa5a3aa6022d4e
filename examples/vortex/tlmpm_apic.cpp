#include "examples/vortex/tlmpm.hpp"

namespace mpm {

template Assembled total_vortex(const VortexSettings&, const Apic<true>&, int);
template Assembled total_vortex(const VortexSettings&, const Consistent<true>&, int);

}  // namespace mpm
