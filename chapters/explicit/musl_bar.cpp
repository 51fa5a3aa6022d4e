/// musl_bar: axial vibration of a bar (review 6.1.1) by MUSL (musl.hpp).
///   ./musl_bar --mode 10
#include "chapters/explicit/musl.hpp"

#include "chapters/explicit/bar_program.hpp"

int main(int argc, char** argv) {
    mpm::Musl scheme;
    return mpm::bar_program<mpm::UpdatedShapes, false>("musl_bar", "axial vibration of a bar by MUSL", scheme, argc, argv);
}
