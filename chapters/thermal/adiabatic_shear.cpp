/// adiabatic_shear: a block yields in fast simple shear, and its plastic work heats it (review B.13), by Algorithm 9
/// (thermo_mechanics.hpp).
///   ./adiabatic_shear --H 0 --plot png
#include "chapters/scenes/sheared_block.hpp"
#include "chapters/thermal/assemble_hot.hpp"

int main(int argc, char** argv) {
    mpm::Common common;
    common.cells = {4};
    common.ppc = 2;
    common.cfl = 0.1;
    const std::vector<mpm::Panel> panels{
        {"",
         "t",
         "time t [s]",
         "mean temperature [K]",
         {{"T_mean", "computed", "lines dt solid lc rgb '#c03030'"}, {"T_mean_exact", "exact", "lines dt 2 lc rgb 'black'"}},
         ""}};
    return mpm::hot_program<mpm::ShearedBlock>("adiabatic_shear", "a block yields in fast simple shear and heats up", mpm::ShearSettings{},
                                               common, 1e-4, panels, argc, argv);
}
