#include "chapters/cpdi/tessellated.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "examples/affine_motion/settings.hpp"
#include "lab/structured.hpp"

namespace mpm {

/// The square tessellated into quadrilaterals, which deform with it.
struct AffineOfDomains : Affine<false>, Tessellated {
    explicit AffineOfDomains(const AffineCase& options) : Affine<false>(options, 2) {}

    std::vector<PolygonCells> tessellate(const std::string&, int cells, int ppc) const {
        return {polygon_cells(quadrilaterals_of(Box{Vec<2>::Zero(), Vec<2>::Ones()}, {cells * ppc, cells * ppc}))};
    }
    template <class Point> std::vector<std::vector<Point>> bodies(int, int) const {
        return bodies_of<Point>(rho, [this](Point& p) { p.v = rate() * p.X; });
    }
    struct Observer : Affine<false>::Observer {};
};

Assembled cpdi_affine(const AffineSettings& s, int cells) {
    return assemble_domain<DomainQ4, false>(Musl{}, AffineOfDomains(s.scene), Flip{s.transfer.alpha}, cells, s.common);
}

}  // namespace mpm
