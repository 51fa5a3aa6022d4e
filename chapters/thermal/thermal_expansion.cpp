/// thermal_expansion: a free plate is heated evenly, by Algorithm 9 (thermo_mechanics.hpp): it strains by alpha dT without stress.
///   ./thermal_expansion --plot png
#include "chapters/scenes/expanding_body.hpp"
#include "chapters/thermal/assemble_hot.hpp"

int main(int argc, char** argv) {
    mpm::Common common;
    common.cells = {10};
    common.ppc = 2;
    common.cfl = 0.5;
    mpm::ExpandingSettings plate;
    plate.plane = true;
    const std::vector<mpm::Panel> panels{
        {"",
         "t",
         "time t [time]",
         "strain [-]",
         {{"eps", "computed", "lines dt solid lc rgb '#c03030'"}, {"eps_exact", "α dT", "lines dt 2 lc rgb 'black'"}},
         ""}};
    return mpm::hot_program<mpm::ExpandingBody<2>>("thermal_expansion", "a free plate is heated evenly", plate, common, 10, panels, argc,
                                                   argv);
}
