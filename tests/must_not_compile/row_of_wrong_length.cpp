// A CSV row with fewer values than columns.
// must say: a row needs one value for each column
#include "lab/record.hpp"

int main() {
    mpm::Csv<3> file("never.csv", {"t", "x", "v"});
    file.row(0.0, 1.0);
}
