/// usl_bar: axial vibration of a bar (review 6.1.1) by USL (usl.hpp).
///   ./usl_bar --mode 10
#include "chapters/explicit/usl.hpp"

#include "chapters/explicit/bar_program.hpp"

int main(int argc, char** argv) {
    mpm::Usl scheme;
    return mpm::bar_program<mpm::UpdatedShapes, false>(
        "usl_bar", "axial vibration of a bar by USL", scheme, argc, argv, [&](mpm::Options& options) {
            options.number("cutoff", scheme.cutoff, "mass", mpm::at_least(0), "nodes with at most this mass are left out (2.63)");
        });
}
