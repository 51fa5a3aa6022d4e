/// usf_bar: axial vibration of a bar (review 6.1.1) by USF (usf.hpp).
///   ./usf_bar --mode 10
#include "chapters/explicit/usf.hpp"

#include "chapters/explicit/bar_program.hpp"

int main(int argc, char** argv) {
    mpm::Usf scheme;
    return mpm::bar_program<mpm::UpdatedShapes, false>("usf_bar", "axial vibration of a bar by USF", scheme, argc, argv);
}
