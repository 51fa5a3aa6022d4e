// resting_column as a user runs it: the exact state of rest, and what stiffness costs an explicit scheme.
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

std::vector<Words> rest(Words words) {
    const Folder folder;
    words.insert(words.end(), {"--cells", "5", "--ramp", "1", "--quiet", "--records", "10", "--out", "run"});
    const Ending ending = folder.run("resting_column", words);
    EXPECT_EQ(ending.code, 0) << ending.err;
    return csv(folder.read("run/summary.csv"));
}
double number(const std::vector<Words>& table, const std::string& column) { return std::stod(field(table, 1, column)); }

// Cells of the total-Lagrangian scheme count the column's own volume, the end is a node: what is left are waves that are not yet damped, in a
// second from the end of the load.
TEST(RestingColumn, RestsWhereItMust) { EXPECT_LT(number(rest({"--scheme", "tlmpm"}), "error"), 1e-5); }
// Of the grid's own cells some are filled by less: off by a part of the strain, 7e-4.
TEST(RestingColumn, RestsToAPartOfTheStrainOnAFixedGrid) { EXPECT_LT(number(rest({"--scheme", "musl"}), "error"), 5e-4); }
TEST(RestingColumn, KnowsAllItsForces) {
    for (const char* scheme : {"tlmpm", "musl"}) {
        const auto table = rest({"--scheme", scheme});
        EXPECT_LT(number(table, "momentum_drift"), 1e-10) << scheme;              // rounding
        EXPECT_LT(std::abs(number(table, "energy_drift")), 0.01) << scheme;  // a leapfrog's work of a growing load: first order in the step
    }
}
TEST(RestingColumn, StiffnessCostsStepsAndNothingElse) {
    const auto soft = rest({"--stiffer", "1"}), stiff = rest({"--stiffer", "100"});
    EXPECT_NEAR(number(stiff, "steps") / number(soft, "steps"), 10, 0.1);  // whole steps
    EXPECT_LT(number(stiff, "error"), 1e-5);
}

}  // namespace
}  // namespace mpm::test
