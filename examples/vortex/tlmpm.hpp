/// Joins the TLMPM with the vortex and every weighting function.
#pragma once
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/improved/transfers.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "examples/vortex/settings.hpp"

namespace mpm {

/// One resolution with --shape and a transfer.
template <class Transfer> Assembled total_vortex(const VortexSettings& s, const Transfer& transfer, int cells) {
    Assembled a;
    AllShapes::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), true>(Tlmpm{s.stress}, Vortex<true>(s.scene), transfer, cells, s.common);
    });
    return a;
}

// Compiled on their own, in tlmpm_apic.cpp: half the time to wait for one file.
extern template Assembled total_vortex(const VortexSettings&, const Apic<true>&, int);
extern template Assembled total_vortex(const VortexSettings&, const Consistent<true>&, int);

}  // namespace mpm
