/// tlmpm_bar: axial vibration of a bar (review 6.1.1) by the total-Lagrangian MPM (tlmpm.hpp).
///   ./tlmpm_bar --mode 10 --stress musl
#include "chapters/explicit/tlmpm.hpp"

#include "chapters/explicit/bar_program.hpp"

int main(int argc, char** argv) {
    mpm::Tlmpm scheme;
    return mpm::bar_program<mpm::AllShapes, true>(
        "tlmpm_bar", "axial vibration of a bar by the total-Lagrangian MPM", scheme, argc, argv, [&](mpm::Options& options) {
            options.choice("stress", scheme.stress, {"musl", "usl"}, "velocities of the stress update: mapped twice (musl) or not (usl)");
        });
}
