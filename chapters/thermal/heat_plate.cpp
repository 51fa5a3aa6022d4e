/// heat_plate: heat conduction in a plate (review 5.3.3, figure 52) by Algorithm 8 (heat.hpp), against the series.
///   ./heat_plate --cells 20 --dt 1e-4 --plot png
#include "chapters/scenes/hot_body.hpp"
#include "chapters/thermal/assemble_heat.hpp"

int main(int argc, char** argv) {
    mpm::HotBodySettings plate;
    plate.T1 = 100;
    mpm::Common common;
    common.cells = {20};
    common.ppc = 2;
    common.cfl = 0.8;
    return mpm::heat_program<mpm::HotBody<2>>("heat_plate", "heat conduction in a plate", plate, common, argc, argv);
}
