#include "examples/mms_square/tlmpm.hpp"

namespace mpm {

Assembled tlmpm_square(const SquareSettings& s, int cells) {
    Assembled a;
    s.transfer.with<true>([&](const auto& transfer) { a = total_square(s, transfer, cells); });
    return a;
}

}  // namespace mpm
