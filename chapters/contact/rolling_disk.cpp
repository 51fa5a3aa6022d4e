/// rolling_disk: a disk rolls or slips down a slope by contact on the grid (bardenhagen.hpp; review 5.1), against the exact motion of a
/// rigid disk.
///   ./rolling_disk --cells 10,20
///   ./rolling_disk --mu 0.1 --plot png
#include "chapters/contact/slope_program.hpp"

int main(int argc, char** argv) {
    return mpm::guarded("rolling_disk", [&] { return mpm::slope_program("rolling_disk", "a disk rolls down a slope", true, argc, argv); });
}
