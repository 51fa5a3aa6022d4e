/// The common part of the CPDI column programs: a kind of domains, the heavy column, two schemes with one kind of node.
#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "chapters/cpdi/gaps.hpp"
#include "chapters/cpdi/tessellated.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/explicit/tlmpm.hpp"
#include "chapters/scenes/heavy_column.hpp"
#include "lab/traits.hpp"

namespace mpm {

/// A mesh of cells with a fixed number of corners as polygons.
template <class Mesh> PolygonCells polygons_of_mesh(const Mesh& mesh) {
    PolygonCells cells{mesh.points, {}};
    for (const auto& corners : mesh.corners) cells.corners.emplace_back(corners.begin(), corners.end());
    return cells;
}
inline PolygonCells rectangles_in(const Box& box, const CellCounts& counts) { return polygons_of_mesh(quadrilaterals_of(box, counts)); }

/// Adds gap and overlap to what is watched, as parts of the area at the start. Domains of a total-Lagrangian body stay where they are.
inline void watch_gaps(Assembled& a, const PolygonCells& mesh, double area) {
    const auto largest = std::make_shared<Gaps>();
    a.simulation.watch = [own = a.simulation.watch, domains = a.simulation.domains, mesh, area, largest](double t) {
        std::vector<double> values = own(t);
        const Gaps now = gaps_between(mesh, polygons_of(domains()));
        *largest = {std::max(largest->gap, now.gap / area), std::max(largest->overlap, now.overlap / area)};
        values.insert(values.end(), {now.gap / area, now.overlap / area});
        return values;
    };
    a.facts = [own = a.facts, largest](double t_end) {
        auto all = own(t_end);
        all.emplace_back("largest gaps / area", largest->gap);
        all.emplace_back("largest overlaps / area", largest->overlap);
        return all;
    };
}

template <class Domain> Assembled assemble_column(const HeavyColumn& column, const std::string& scheme, int cells, const Common& common) {
    Assembled a;
    HeavyColumn tessellated = column;
    const PolygonCells mesh = counter_clockwise(tessellated.tessellate(Domain::name, cells, common.ppc)[0]);
    tessellated.mesh_of = [mesh](const Box&, const CellCounts&) { return mesh; };
    if (scheme == "musl") a = assemble_domain<Domain, false>(Musl{}, tessellated, Flip{}, cells, common);
    else a = assemble_domain<Domain, true>(Tlmpm{}, tessellated, Flip{}, cells, common);
    watch_gaps(a, mesh, column.box().area());
    if (!column.held_sides()) a.row.reference = "none";
    return a;
}

/// Runs the heavy column with domains of one kind; `mesh_of` tessellates its box.
template <class Domain, class MeshOf> int column_program(const std::string& program, MeshOf&& mesh_of, int argc, char** argv) {
    return guarded(program, [&] {
        Options options(program, "a compliant column in strong gravity by " + std::string(Domain::name));
        HeavyColumn column;
        column.mesh_of = mesh_of;
        Common common;
        std::string scheme = "musl";
        common.cells = {16};
        common.records = 100;  // gaps take as long as many steps
        common.ppc = 2;
        common.shape = Domain::name;
        options.choice("scheme", scheme, {"musl", "tlmpm"}, "domains that move with the grid, or total-Lagrangian ones");
        column.declare(options);
        common.declare(options, {Domain::name}, 0.25, traits_of(column));
        options.parse(argc, argv);
        if (answered(options, program)) return 0;
        Panel sag{"", "t", "time t [time]", "sag of the tip [length]", {{"tip", "computed", "lines dt solid lc rgb '#c03030'"}}, ""};
        if (column.held_sides()) sag.curves.push_back({"tip_static", "at rest", "lines dt 2 lc rgb 'black'"});
        std::vector<Panel> panels{sag};
        if constexpr (std::is_same_v<Domain, DomainR4>)  // the others have none but rounding
            panels.push_back({"",
                              "t",
                              "time t [time]",
                              "part of the area [-]",
                              {{"gap", "gaps", "lines dt solid lc rgb '#3060c0'"}, {"overlap", "overlaps", "lines dt 2 lc rgb '#c03030'"}},
                              ""});
        const Description about{program, "a column by " + std::string(Domain::name), HeavyColumn::name, HeavyColumn::solves,
                                {"tip", "tip_static", "gap", "overlap"}, 0, panels};
        return run_program(about, options, common, [&](int cells) { return assemble_column<Domain>(column, scheme, cells, common); });
    });
}

}  // namespace mpm
