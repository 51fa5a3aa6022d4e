/// thermal_bar_clamped: a bar between clamps is heated, by Algorithm 9 (thermo_mechanics.hpp): its stress is -E alpha times the mean rise
/// of temperature.
///   ./thermal_bar_clamped --heating end --cells 25,50,100
#include "chapters/scenes/expanding_body.hpp"
#include "chapters/thermal/assemble_hot.hpp"

int main(int argc, char** argv) {
    mpm::Common common;
    common.ppc = 2;
    common.cfl = 0.5;
    const std::vector<mpm::Panel> panels{{"",
                                          "t",
                                          "time t [time]",
                                          "mean stress [stress]",
                                          {{"stress", "computed", "lines dt solid lc rgb '#c03030'"},
                                           {"stress_exact", "-E α times the mean rise of T", "lines dt 2 lc rgb 'black'"}},
                                          ""}};
    return mpm::hot_program<mpm::ExpandingBody<1>>("thermal_bar_clamped", "a bar between clamps is heated", mpm::ExpandingSettings{},
                                                   common, 50, panels, argc, argv);
}
