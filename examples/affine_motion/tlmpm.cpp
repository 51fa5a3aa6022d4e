#include "chapters/explicit/tlmpm.hpp"

#include "chapters/weighting/assemble_with.hpp"
#include "examples/affine_motion/settings.hpp"

namespace mpm {

namespace {

template <class Transfer> Assembled total_affine(const AffineSettings& s, const Transfer& transfer, int cells) {
    Assembled a;
    AffineShapes::with(s.common.shape, [&](auto kernel) {
        a = assemble_with<decltype(kernel), true>(Tlmpm{s.stress}, Affine<true>(s.scene, 1), transfer, cells, s.common);
    });
    return a;
}

}  // namespace

Assembled tlmpm_affine(const AffineSettings& s, int cells) {
    if (s.transfer.name == "apic") return total_affine(s, Apic<true>{}, cells);
    if (s.transfer.name == "fmpm") return total_affine(s, Fmpm{s.transfer.order}, cells);
    return total_affine(s, Flip{s.transfer.alpha}, cells);
}

}  // namespace mpm
