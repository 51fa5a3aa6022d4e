/// heat_bar: heat conduction in a bar (review 5.3.3, figure 51) by Algorithm 8 (heat.hpp), against the series.
///   ./heat_bar --cells 100 --dt 8e-5 --form printed
#include "chapters/scenes/hot_body.hpp"
#include "chapters/thermal/assemble_heat.hpp"

int main(int argc, char** argv) {
    mpm::Common common;
    common.cells = {100};
    common.cfl = 0.8;
    return mpm::heat_program<mpm::HotBody<1>>("heat_bar", "heat conduction in a bar", {}, common, argc, argv);
}
