/// Correction of the receding contact (Aulisa and Capodaglio, section 5): a particle that moves away from a held face is strained as if the
/// face followed it in part, so that it does not stick.
#pragma once
#include <array>
#include <cstddef>

#include "chapters/implicit/element.hpp"

namespace mpm {

/// The lower face of a row of elements along an axis: held, or that of a finite element body. The printed (47) has its weights swapped: from
/// u' = 0 on the face, -3/2 u_1 + 2 u_8 - u_4/2 = 0, follows u_1* = (1 - C_c) u_1 + C_c (4/3 u_8 - 1/3 u_4), the middle node with 4/3. Moves
/// away: v.n > 0 at the start of the step, less the face's velocity.
struct RecedingContact {
    double C_c = 0;  // 0: held as it is ... 1: no normal strain on the face [-]
    int axis = 1;
    int row = 0;     // of the elements over the face

    /// Whether an element lies on the face, which some correction is made for.
    template <class Element, int D> bool on_face(const Rectilinear<D>& grid, int element) const {
        return D == 2 && Element::stride == Element::count - 1 && C_c != 0 && grid.place(element, axis) == row;
    }
    /// Of a face at rest.
    template <class Element, int D, class Point, int N>
    void correct(const Rectilinear<D>& grid, int element, const Point& p, ElementWeights<D, N>& w) const {
        if (on_face<Element>(grid, element) && p.v[axis] > 0) follow<Element>(w);
    }
    template <class Element, int D, int N> void follow(ElementWeights<D, N>& w) const {
        if constexpr (D == 2) {
            const std::size_t step = axis == 0 ? 1 : Element::count;
            for (std::size_t k = 0; k < static_cast<std::size_t>(N); ++k) {
                if (k / step % Element::count != 0) continue;
                if constexpr (Element::count == 3) {
                    w.trial[k + step] += C_c * 4 / 3 * w.grad[k];
                    w.trial[k + 2 * step] -= C_c / 3 * w.grad[k];
                } else {
                    w.trial[k + step] += C_c * w.grad[k];
                }
                w.trial[k] = (1 - C_c) * w.grad[k];
            }
        }
    }
};

}  // namespace mpm
