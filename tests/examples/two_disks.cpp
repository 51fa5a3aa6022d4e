// two_disks as a user runs it (review 6.1.2), against NUMBERS section 11: dt = 1e-3, t = 3.5.
#include <algorithm>
#include <cmath>

#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

struct Rebound {
    Ending ending;
    std::vector<Words> summary, history;

    double error(const std::string& name) const {
        for (std::size_t row = 1; row < summary.size(); ++row)
            if (field(summary, row, "error_name") == name) return std::stod(field(summary, row, "error"));
        return std::nan("");
    }
    double number(const std::string& column) const { return std::stod(field(summary, 1, column)); }
    double last(const std::string& column) const { return std::stod(field(history, history.size() - 1, column)); }
    double first(const std::string& column) const { return std::stod(field(history, 1, column)); }
    double least(const std::string& column) const {
        double low = first(column);
        for (std::size_t row = 1; row < history.size(); ++row) low = std::min(low, std::stod(field(history, row, column)));
        return low;
    }
    /// Growth of kinetic and strain energy, relative to the start.
    double growth() const { return last("total") / first("total") - 1; }
};

Rebound rebound(Words words, int code = 0) {
    const Folder folder;
    words.insert(words.end(), {"--dt", "1e-3", "--quiet", "--out", "run"});
    Rebound r;
    r.ending = folder.run("two_disks", words);
    EXPECT_EQ(r.ending.code, code) << r.ending.err;
    r.summary = csv(folder.read("run/summary.csv"));
    r.history = csv(folder.read("run/history.csv"));
    return r;
}

// The particles cover more than the disks: 416 x rho/4 h^2 x v0^2 = 2.6, not 2.513.
TEST(TwoDisks, StartsWithTheKineticEnergyOfItsParticles) {
    const Rebound r = rebound({"--t-end", "0.01"});
    EXPECT_EQ(field(r.summary, 1, "particles"), "416");
    EXPECT_NEAR(r.first("kinetic"), 2.6, 1e-12);
}

struct Reference {
    const char *scheme, *shape, *law;
    double growth, tolerance, least;
};
class TwoDisksEnergy : public testing::TestWithParam<Reference> {};

// Energy at the end within a tenth of a per cent of the reference, least kinetic energy within a per cent. USL's loss hangs on what its cut-off
// leaves out (no value is given): half a per cent.
TEST_P(TwoDisksEnergy, AgreesWithTheReference) {
    const Reference& reference = GetParam();
    Words words{"--scheme", reference.scheme, "--shape", reference.shape, "--law", reference.law};
    if (std::string(reference.scheme) == "usl") words.insert(words.end(), {"--cutoff", "1e-3"});
    const Rebound r = rebound(words);
    EXPECT_NEAR(r.growth(), reference.growth, reference.tolerance);
    EXPECT_NEAR(r.least("kinetic") / reference.least, 1, 0.015);
}
INSTANTIATE_TEST_SUITE_P(Variants, TwoDisksEnergy,
                         testing::Values(Reference{"musl", "hat", "linear", 0.0013, 1e-3, 0.0738}, Reference{"usf", "hat", "linear", 0.0030, 1e-3, 0.0735},
                                         Reference{"usl", "hat", "linear", -0.0374, 5e-3, 0.0642},
                                         Reference{"musl", "ugimp", "linear", 0.0046, 1e-3, 0.0933},
                                         Reference{"usl", "ugimp", "linear", -0.0166, 5e-3, 0.0892},
                                         Reference{"musl", "cubic", "linear", -0.0019, 1e-3, 0.1765},
                                         Reference{"usl", "cubic", "linear", -0.0563, 5e-3, 0.1713},
                                         Reference{"musl", "hat", "neo-hookean", -0.00017, 1e-4, 0.0698},
                                         Reference{"usf", "hat", "neo-hookean", 0.00105, 1e-4, 0.0692},
                                         Reference{"musl", "cubic", "neo-hookean", -0.000, 1e-5, 0.1787}),
                         [](const auto& test) {
                             std::string name = std::string(test.param.scheme) + "_" + test.param.shape + "_" + test.param.law;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// Nothing acts on the disks from outside. The cut-off drops the momentum of nodes, and the summary says how much.
TEST(TwoDisks, KeepMomentumUnlessNodesAreLeftOut) {
    for (const char* scheme : {"usl", "usf", "musl"}) EXPECT_LT(std::abs(rebound({"--scheme", scheme}).number("momentum_drift")), 1e-12) << scheme;
    EXPECT_GT(rebound({"--scheme", "usl", "--cutoff", "1e-3"}).number("momentum_drift"), 1e-9);
}
// The problem is its own mirror image; only rounding is not.
TEST(TwoDisks, MirrorEachOtherToTheEnd) { EXPECT_LT(rebound({"--scheme", "musl"}).last("asymmetry"), 1e-10); }

// Disks touch at 1.5858; the shared field lets them feel each other up to a cell earlier: NUMBERS has 1.260, 1.360 (h = 1/20), 1.460, 1.492
// (1/40) for 0.1 % and 1 %, sampled more coarsely than at every step.
TEST(TwoDisks, FeelEachOtherTooEarlyByLessAndLess) {
    const double exact = 0.6 * std::sqrt(2.0) / (0.2 * std::sqrt(2.0)) - 0.4 / (0.2 * std::sqrt(2.0));
    EXPECT_NEAR(exact, 1.5858, 1e-4);
    const Rebound coarse = rebound({}), fine = rebound({"--cells", "40"});
    EXPECT_NEAR(exact * (1 - coarse.error("contact_0.1%")), 1.260, 0.01);
    EXPECT_NEAR(exact * (1 - coarse.error("contact_1%")), 1.360, 0.01);
    EXPECT_NEAR(exact * (1 - fine.error("contact_0.1%")), 1.460, 0.005);
    EXPECT_NEAR(exact * (1 - fine.error("contact_1%")), 1.492, 0.005);
}

TEST(TwoDisks, OfTotalLagrangianSchemesEndWhenTheyLieInEachOther) {
    for (const char* shape : {"hat", "bernstein"}) {
        const Rebound r = rebound({"--scheme", "tlmpm", "--shape", shape}, 3);
        EXPECT_EQ(field(r.summary, 1, "verdict"), "unstable:bodies-passed-through");
        EXPECT_EQ(field(r.summary, 1, "error"), "nan");
        EXPECT_NEAR(r.number("t_fail"), 1.5858, 0.25);  // a cell's depth takes h/(2 sqrt 2 v0) = .18
    }
}
TEST(TwoDisks, RefusesWhatDoesNotGoTogether) {
    for (const auto& [words, parts] : std::vector<std::pair<Words, Words>>{{{"--shape", "bernstein"}, {"--shape bernstein", "tlmpm"}},
                                                                           {{"--cutoff", "1"}, {"--cutoff", "musl"}},
                                                                           {{"--radius", "0.3"}, {"--radius", "0.3"}},
                                                                           {{"--radius", "0.02", "--cells", "3", "--ppc", "1"}, {"no particle"}},
                                                                           {{"--law", "hooke"}, {"--law", "neo-hookean"}}}) {
        const Folder folder;
        expect_one_line(folder.run("two_disks", words), 2, parts);
        EXPECT_TRUE(folder.empty());
    }
}

}  // namespace
}  // namespace mpm::test
