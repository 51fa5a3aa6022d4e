#include "examples/vortex/tlmpm.hpp"

namespace mpm {

Assembled tlmpm_vortex(const VortexSettings& s, int cells) {
    Assembled a;
    s.transfer.with<true>([&](const auto& transfer) { a = total_vortex(s, transfer, cells); });
    return a;
}

}  // namespace mpm
