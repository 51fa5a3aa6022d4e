/// What shares the grid with the particles of implicit MPM: here nothing. A finite element body that does
/// (chapters/coupling/monolithic.hpp) tells the same.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "chapters/implicit/element.hpp"
#include "chapters/implicit/receding.hpp"
#include "lab/monitor.hpp"

namespace mpm {

/// Every step begins with a grid that is not deformed.
template <class Element, class Body> struct Alone {
    static constexpr bool any = false;
    static constexpr int D = Body::D;
    using Point = typename Body::Point;

    int element(const Rectilinear<D>& grid, std::size_t, const Point& p) const { return grid.element_at(p.x); }
    auto weights(const Rectilinear<D>& grid, int element, std::size_t, const Point& p) const {
        return element_weights<Element, D>(grid, element, p.x);
    }
    bool recedes(const RecedingContact& contact, const Rectilinear<D>& grid, int element, std::size_t, const Point& p) const {
        return contact.on_face<Element>(grid, element) && p.v[contact.axis] > 0;
    }

    const std::vector<int>& elements() const {
        static const std::vector<int> none;
        return none;
    }
    std::vector<const Body*> bodies() const { return {}; }
    void measure(Measures&) const {}
    Trouble trouble() const { return {}; }
    void keep() {}
    void restore() {}
};

}  // namespace mpm
