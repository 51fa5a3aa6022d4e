/// sliding_block: a block slides down a slope, or sticks on it, by contact on the grid (bardenhagen.hpp; review 5.1), against the exact
/// motion of a rigid block.
///   ./sliding_block --cells 10,20
///   ./sliding_block --scheme usf --rise 0 --normals gradient --common off --gap velocity    # as printed: 88 % too little
#include "chapters/contact/slope_program.hpp"

int main(int argc, char** argv) {
    return mpm::guarded("sliding_block",
                        [&] { return mpm::slope_program("sliding_block", "a block slides down a slope", false, argc, argv); });
}
