#include "lab/smooth.hpp"

#include <algorithm>

namespace mpm {

std::vector<double> smoothed(const Mapping& map, const std::vector<double>& m, const std::vector<double>& field) {
    if (m.empty()) return {};
    const std::size_t components = field.size() / m.size();
    const auto nodes = static_cast<std::size_t>(*std::max_element(map.node.begin(), map.node.end())) + 1;
    std::vector<double> mass(nodes, 0.0), of_node(nodes * components, 0.0), result(field.size(), 0.0);
    const auto each = [&](auto&& visit) {
        for (std::size_t p = 0; p < m.size(); ++p)
            for (std::size_t k = p * map.touched; k < (p + 1) * map.touched; ++k)
                visit(p, static_cast<std::size_t>(map.node[k]), map.phi[k]);
    };
    each([&](std::size_t p, std::size_t I, double phi) {
        mass[I] += phi * m[p];
        for (std::size_t c = 0; c < components; ++c) of_node[I * components + c] += phi * m[p] * field[p * components + c];
    });
    each([&](std::size_t p, std::size_t I, double phi) {
        if (!(mass[I] > 0)) return;
        for (std::size_t c = 0; c < components; ++c) result[p * components + c] += phi * of_node[I * components + c] / mass[I];
    });
    return result;
}

}  // namespace mpm
