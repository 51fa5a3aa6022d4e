#include "chapters/contact/slope_program.hpp"

#include "lab/traits.hpp"

namespace mpm {

namespace {

std::vector<Panel> panels(bool disk) {
    std::vector<Panel> all{{"",
                            "t",
                            "time t [time]",
                            "travel [length]",
                            {{"travel", "computed", "lines dt solid lc rgb '#c03030'"},
                             {"travel_exact", "rigid body", "lines dt 2 lc rgb 'black'"}},
                            ""}};
    if (disk)
        all.push_back({"",
                       "t",
                       "time t [time]",
                       "angular velocity [1/time]",
                       {{"spin", "computed", "lines dt solid lc rgb '#c03030'"}, {"spin_exact", "rigid disk", "lines dt 2 lc rgb 'black'"}},
                       ""});
    return all;
}

}  // namespace

int slope_program(const char* program, const char* purpose, bool disk, int argc, char** argv) {
    Options options(program, purpose);
    SlopeRun s;
    s.disk = disk;
    s.common.cells = {10};
    s.common.ppc = disk ? 4 : 3;  // fewer leave nodes of little mass, where hat functions gain energy
    s.slope.placing = disk ? "rings" : "cells";
    s.slope.rise = 0.2;
    s.common.cfl = 0.2;
    s.common.records = 400;
    options.choice("scheme", s.scheme, {"usl", "usf", "musl"}, "method");
    s.slope.declare(options, disk);
    s.contact.declare(options);
    s.common.declare(options, {"hat"}, 1.2, traits_of(Slope{}));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    const Description about{program, purpose, Slope::name, Slope::solves, {Slope::columns.begin(), Slope::columns.end()}, 0, panels(disk)};
    return run_program(about, options, s.common, [&](int cells) {
        if (s.scheme == "usl") return usl_slope(s, cells);
        if (s.scheme == "musl") return musl_slope(s, cells);
        return usf_slope(s, cells);
    });
}

}  // namespace mpm
