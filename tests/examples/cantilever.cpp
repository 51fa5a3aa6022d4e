// cantilever as a user runs it, with few particles.
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

std::vector<Words> swing(Words words) {
    const Folder folder;
    words.insert(words.end(), {"--rows", "10", "--layers", "5", "--cells", "16", "--quiet", "--out", "run"});
    const Ending ending = folder.run("cantilever", words);
    EXPECT_EQ(ending.code, 0) << ending.err;
    return csv(folder.read("run/summary.csv"));
}
double number(const std::vector<Words>& table, const std::string& column) { return std::stod(field(table, 1, column)); }

// In a small swing both schemes solve the same equations to order strain, 1e-6, but for particles that lie on cell borders.
TEST(Cantilever, SchemesAgreeInASmallSwing) {
    const Words small{"--g", "1e-3", "--t-end", "1.6", "--shape", "hat", "--reference", "1.3464", "--scheme"};
    const auto with = [&](const char* scheme) {
        Words words = small;
        words.push_back(scheme);
        return number(swing(words), "error");
    };
    const double tlmpm = with("tlmpm");
    EXPECT_NEAR(with("musl"), tlmpm, 1e-3);
    EXPECT_LT(tlmpm, 0.1);  // hat functions, four cells across: 6 % too stiff
}
TEST(Cantilever, StiffEndShortensTheStepsAndBeamTheoryDoesNotKnowIt) {
    const auto uniform = swing({"--t-end", "0.1"}), stiff = swing({"--t-end", "0.1", "--contrast", "100"});
    EXPECT_NEAR(number(stiff, "steps") / number(uniform, "steps"), 10, 0.2);
    EXPECT_LT(number(stiff, "momentum_drift"), 1e-10);
    EXPECT_EQ(field(stiff, 1, "error"), "nan");
}
TEST(Cantilever, CountsItsParticlesAnotherWay) {
    const Folder folder;
    const Ending ending = folder.run("cantilever", {"--ppc", "2"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_EQ(ending.err.find('\n'), ending.err.size() - 1) << ending.err;
}

}  // namespace
}  // namespace mpm::test
