/// What a particle and a node tell in a snapshot: columns and values that are matched when the program is compiled.
///
/// A law may add columns, e.g. a plastic strain: `static constexpr std::array<const char*, N> columns` and
/// `template <class Point> std::array<double, N> values(const Point&) const`. It may also tell the stress that plane strain makes out of
/// plane: `template <class Point> double sigma_zz(const Point&) const`. If it does not, there is no column szz, and pressure and von Mises
/// stress take the mean of sxx and syy for it, which is exact for an incompressible material.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "lab/body.hpp"
#include "lab/smooth.hpp"
#include "lab/snapshot.hpp"

namespace mpm {

template <std::size_t N> using Names = std::array<const char*, N>;

namespace detail {
template <class T, std::size_t... N> constexpr std::array<T, (N + ... + 0)> joined(const std::array<T, N>&... parts) {
    std::array<T, (N + ... + 0)> all{};
    std::size_t n = 0;
    const auto append = [&](const auto& part) {
        for (const T& value : part) all[n++] = value;
    };
    (append(parts), ...);
    return all;
}
template <class Law, class Point> constexpr bool knows_zz = requires(const Law& law, const Point& p) { law.sigma_zz(p); };
template <class Point> constexpr bool has_material = requires(const Point& p) { p.material; };
template <class Law> constexpr bool has_columns = requires { Law::columns; };
}  // namespace detail

/// The stress in a plane and across it.
struct PlaneStress {
    double xx, yy, xy, zz;
    double pressure() const { return -(xx + yy + zz) / 3; }
    double mises() const {  // sqrt(3/2 s:s), s the deviator
        const double a = xx - yy, b = yy - zz, c = zz - xx;
        return std::sqrt((a * a + b * b + c * c) / 2 + 3 * xy * xy);
    }
};
template <class Law, class Point> PlaneStress stress_of(const Law& law, const Point& p) {
    const double xx = p.sigma(0, 0), yy = p.sigma(1, 1);
    if constexpr (detail::knows_zz<Law, Point>) return {xx, yy, p.sigma(0, 1), law.sigma_zz(p)};
    else return {xx, yy, p.sigma(0, 1), (xx + yy) / 2};
}

/// A particle's columns, without its smoothed stress.
template <int D, class Point, class Law> constexpr auto particle_columns() {
    constexpr auto own = [] {
        if constexpr (detail::has_columns<Law>) return Law::columns;
        else return Names<0>{};
    }();
    constexpr auto material = [] {
        if constexpr (detail::has_material<Point>) return Names<1>{"material"};
        else return Names<0>{};
    }();
    constexpr auto across = [] {
        if constexpr (detail::knows_zz<Law, Point>) return Names<1>{"szz"};
        else return Names<0>{};
    }();
    if constexpr (D == 1)
        return detail::joined(Names<6>{"body", "x", "v", "F", "sigma", "V"}, material, own);
    else
        return detail::joined(Names<8>{"body", "x", "y", "vx", "vy", "sxx", "syy", "sxy"}, across,
                              Names<5>{"J", "V", "pressure", "mises", "speed"}, material, own);
}

/// A particle's values, one for each of its columns.
template <int D, class Point, class Law> auto particle_row(double body, const Law& law, const Point& p) {
    const auto own = [&] {
        if constexpr (detail::has_columns<Law>) return law.values(p);
        else return std::array<double, 0>{};
    }();
    const auto material = [&] {
        if constexpr (detail::has_material<Point>) return std::array<double, 1>{static_cast<double>(p.material)};
        else return std::array<double, 0>{};
    }();
    if constexpr (D == 1) {
        return detail::joined(std::array<double, 6>{body, p.x[0], p.v[0], p.F(0, 0), p.sigma(0, 0), p.V}, material, own);
    } else {
        const PlaneStress s = stress_of(law, p);
        const auto across = [&] {
            if constexpr (detail::knows_zz<Law, Point>) return std::array<double, 1>{s.zz};
            else return std::array<double, 0>{};
        }();
        return detail::joined(std::array<double, 8>{body, p.x[0], p.x[1], p.v[0], p.v[1], s.xx, s.yy, s.xy}, across,
                              std::array<double, 5>{p.V / p.V0, p.V, s.pressure(), s.mises(), p.v.norm()}, material, own);
    }
}

/// The columns of the smoothed stress; pressure and von Mises stress are those of the smoothed components.
template <int D> constexpr auto smooth_columns() {
    if constexpr (D == 1) return Names<1>{"sigma_smooth"};
    else return Names<6>{"sxx_smooth", "syy_smooth", "sxy_smooth", "szz_smooth", "pressure_smooth", "mises_smooth"};
}

/// The smoothed stress of a body's particles, row after row; nan while a particle is outside the grid.
template <int D, class Matter> std::vector<double> smooth_rows(const Matter& body, const std::function<Mapping()>& mapping) {
    const std::size_t n = body.points.size();
    std::vector<double> m, field, rows;
    for (const auto& p : body.points) {
        m.push_back(p.m);
        if constexpr (D == 1) {
            field.push_back(p.sigma(0, 0));
        } else {
            const PlaneStress s = stress_of(body.law, p);
            field.insert(field.end(), {s.xx, s.yy, s.xy, s.zz});
        }
    }
    try {
        field = smoothed(mapping(), m, field);
    } catch (const OutsideGrid&) {
        field.assign(field.size(), std::numeric_limits<double>::quiet_NaN());
    }
    if constexpr (D == 1) return field;
    for (std::size_t i = 0; i < n && D == 2; ++i) {
        const PlaneStress s{field[4 * i], field[4 * i + 1], field[4 * i + 2], field[4 * i + 3]};
        rows.insert(rows.end(), {s.xx, s.yy, s.xy, s.zz, s.pressure(), s.mises()});
    }
    return rows;
}

/// None, for snapshots.
struct NoRigidBodies {};

/// Particles {x, v} of rigid bodies as bodies of their own, without stress, in squares of a quarter of a cell; all else is zero.
template <int D, class RigidBodies> void add_rigid(Snapshot& s, const RigidBodies& rigid, double first_number, double V) {
    for (const auto& body : rigid) {
        for (const auto& p : body) {
            std::vector<double> row(s.columns.size(), 0);
            const auto set = [&](const char* name, double value) {
                if (const std::size_t column = s.find(name); column < row.size()) row[column] = value;
            };
            set("body", first_number), set("V", V), set("J", 1), set("x", p.x[0]), set(D == 1 ? "v" : "vx", p.v[0]);
            if constexpr (D == 2) set("y", p.x[1]), set("vy", p.v[1]), set("speed", p.v.norm());
            s.values.insert(s.values.end(), row.begin(), row.end());
        }
        ++first_number;
    }
}

/// All particles of the bodies, pointers to Matter, in the order of their numbers; with `mapping(body's number)` also their smoothed
/// stress. Those of rigid bodies follow.
template <int D, class Matter, class RigidBodies = NoRigidBodies>
Snapshot particles_of(const std::vector<Matter*>& bodies, const std::function<Mapping(std::size_t)>& mapping = {},
                      const RigidBodies& rigid = {}) {
    using Point = typename Matter::Point;
    using Law = typename Matter::Law;
    constexpr auto columns = particle_columns<D, Point, Law>();
    constexpr auto smooth = smooth_columns<D>();
    Snapshot s{{columns.begin(), columns.end()}};
    if (mapping) s.columns.insert(s.columns.end(), smooth.begin(), smooth.end());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Matter& body = *bodies[b];
        std::vector<double> more;
        if (mapping) more = smooth_rows<D>(body, [&] { return mapping(b); });
        std::vector<std::size_t> place(body.points.size());  // of each number
        for (std::size_t i = 0; i < place.size(); ++i) place[body.number(i)] = i;
        for (const std::size_t i : place) {
            const auto row = particle_row<D>(static_cast<double>(b), body.law, body.points[i]);
            static_assert(row.size() == columns.size(), "a particle's row needs one value for each column");
            s.add(row);
            if (!mapping) continue;
            const auto first = more.begin() + static_cast<std::ptrdiff_t>(i * smooth.size());
            s.values.insert(s.values.end(), first, first + static_cast<std::ptrdiff_t>(smooth.size()));
        }
    }
    if constexpr (!std::is_same_v<RigidBodies, NoRigidBodies>)
        add_rigid<D>(s, rigid, static_cast<double>(bodies.size()), bodies.front()->grid.lattice().h().prod() / power(2, D));
    return s;
}

/// The corners of the particles' domains, row after row with the columns of their particle; `particle` counts over all bodies.
template <class Body> Snapshot domains_of(const std::vector<Body>& bodies) {
    constexpr auto columns = detail::joined(Names<1>{"particle"}, particle_columns<2, typename Body::Point, typename Body::Law>());
    Snapshot s{{columns.begin(), columns.end()}};
    const std::size_t x = s.find("x"), y = s.find("y");
    double body_number = 0, number = 0;
    for (const Body& body : bodies) {
        for (std::size_t i = 0; i < body.points.size(); ++i, ++number) {
            auto row = detail::joined(std::array<double, 1>{number}, particle_row<2>(body_number, body.law, body.points[i]));
            for (const Vec<2>& corner : body.shape.corners_of(i)) {
                row[x] = corner[0], row[y] = corner[1];
                s.add(row);
            }
        }
        ++body_number;
    }
    return s;
}

/// Position, mass and momentum of every node.
template <int D, class Matter> GridSnapshot nodes_of(const std::vector<Matter*>& bodies) {
    constexpr auto columns = [] {
        if constexpr (D == 1) return Names<4>{"body", "x", "m", "mv"};
        else return Names<6>{"body", "x", "y", "m", "mvx", "mvy"};
    }();
    GridSnapshot s;
    s.columns = {columns.begin(), columns.end()};
    const Lattice<D>& lattice = bodies.front()->grid.lattice();
    for (int d = 0; d < D; ++d) {
        const auto axis = static_cast<std::size_t>(d);
        s.nodes[axis] = lattice.nodes(d);
        s.origin[axis] = lattice.origin()[d];
        s.spacing[axis] = lattice.h()[d] / lattice.per_cell();
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (int I = 0; I < bodies[b]->grid.size(); ++I) {
            const auto& node = bodies[b]->grid[I];
            const Vec<D> x = bodies[b]->grid.lattice().position(I);
            const double number = static_cast<double>(b);
            if constexpr (D == 1) s.add(std::array<double, columns.size()>{number, x[0], node.m, node.mv_new[0]});
            else s.add(std::array<double, columns.size()>{number, x[0], x[1], node.m, node.mv_new[0], node.mv_new[1]});
        }
    return s;
}

namespace detail {
template <int Dim> struct Bare {  // what a law extends, where only names of columns are asked for
    static constexpr int D = Dim;
};
}  // namespace detail

/// Every column that `--colour` may name for particles under this law in 2D; in 1D none.
template <int D, class Law> std::vector<std::string> colours() {
    if constexpr (D == 1) return {};
    constexpr auto columns = particle_columns<D, typename WithHistory<Law, detail::Bare<D>>::Point, Law>();
    constexpr auto smooth = smooth_columns<D>();
    std::vector<std::string> all(columns.begin(), columns.end());
    all.insert(all.end(), smooth.begin(), smooth.end());
    return all;
}

}  // namespace mpm
