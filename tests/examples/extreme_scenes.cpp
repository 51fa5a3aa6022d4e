// affine_motion, flying_bar and the extremes of contrast_bar as a user runs them, against their exact solutions.
#include <cmath>

#include "chapters/mms/affine.hpp"
#include "chapters/scenes/contrast_bar.hpp"
#include "chapters/scenes/flying_bar.hpp"
#include "chapters/explicit/point.hpp"
#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

struct Ran {
    std::string verdict;
    double error;
};
/// The error of that name.
Ran ran(const std::string& program, Words words, const std::string& error) {
    const Folder folder;
    words.insert(words.end(), {"--quiet", "--records", "50", "--out", "run"});
    const Ending ending = folder.run(program, words);
    EXPECT_TRUE(ending.code == 0 || ending.code == 3) << ending.err;
    const auto table = csv(folder.read("run/summary.csv"));
    for (std::size_t row = 1; row < table.size(); ++row)
        if (field(table, row, "error_name") == error) return {field(table, row, "verdict"), std::stod(field(table, row, "error"))};
    ADD_FAILURE() << program << " has no error " << error;
    return {"", 0};
}
Words words(const std::string& text) {
    Words all;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(' ', from), text.size());
        all.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return all;
}

// The motion is linear in time and in place, and so are hat functions on the initial square: nothing but rounding, however far.
TEST(AffineMotion, IsExactForTheTlmpmWithHats) {
    for (const char* motion : {"stretch --amount 10", "compress --amount 0.02", "shear --amount 5"})
        EXPECT_LT(ran("affine_motion", words(std::string("--scheme tlmpm --cfl 0.2 --motion ") + motion), "stress").error, 1e-10) << motion;
}
// Particles of hat functions go apart until cells between them are empty.
TEST(AffineMotion, StretchTearsUpdatedHatsAndSaysSo) {
    for (const char* scheme : {"usl", "usf", "musl"})
        EXPECT_EQ(ran("affine_motion", words(std::string("--motion stretch --amount 10 --cfl 0.2 --scheme ") + scheme), "stress").verdict,
                  "unstable:numerical-fracture");
}
TEST(AffineMotion, WaveSpeedIsThatOfTheStretchedSolid) {
    AffineCase square;
    square.motion = "stretch", square.amount = 3;
    const double lambda = square.lambda(), mu = square.mu();
    // along x: on the body rho c^2 = mu 9 + lambda + mu; on the initial square along y, the narrow direction's stretch being 1
    EXPECT_NEAR(square.wave_speed(false), std::sqrt(9 * mu + lambda + mu), 1e-12);
    EXPECT_NEAR(square.wave_speed(true), std::sqrt(mu + lambda + mu), 1e-12);
}

// Balances of mass and momentum across the shock, and the law of the bar.
TEST(FlyingBar, ShockKeepsMassAndMomentum) {
    for (const double mach : {0.1, 1.0, 5.0}) {
        FlyingBarCase settings;
        settings.mach = mach;
        const FlyingBar<false> bar(settings, 10);
        Point<1> p;
        p.F(0, 0) = bar.shocked();
        bar.law().update(p, p.F, 0);
        const double U = bar.shock_speed(), V = bar.speed();
        EXPECT_NEAR(U * (1 - bar.shocked()), V, 1e-12 * V);
        EXPECT_NEAR(bar.rho * U * V, -p.sigma(0, 0), 1e-9 * U * V);  // P = sigma in one dimension; F = .02 is known to 1e-16
    }
}
// Slow impact: an elastic wave; rms over the run.
TEST(FlyingBar, EverySchemeStopsAtTheWall) {
    for (const char* scheme : {"usl", "usf", "musl", "tlmpm", "impm", "cpdi"}) {
        const Ran r = ran("flying_bar", words(std::string("--mach 0.1 --cells 50 --scheme ") + scheme), "v_cm");
        EXPECT_EQ(r.verdict, "ok");
        EXPECT_LT(r.error, 0.02) << scheme;  // a cell of the bar's length
    }
}
TEST(FlyingBar, FmpmTakesAShockFiveTimesAsFastAsSound) {
    const Ran r = ran("flying_bar", words("--mach 5 --cells 100 --scheme tlmpm --shape cubic --transfer fmpm --order 4"), "v_cm");
    EXPECT_EQ(r.verdict, "ok");
    EXPECT_LT(r.error, 0.01);  // a cell of the bar's length
}
TEST(FlyingBar, OneParticleAloneIsNotStrainedByItsFlight) {
    for (const char* scheme : {"usl", "usf", "musl", "impm", "cpdi"}) {
        const Words flight = words("--into nothing --mach 0.01 --cells 20 --strain 1e-4 --size 1 --ppc 1 --crossings 5 --scheme");
        Words all = flight;
        all.push_back(scheme);
        const Ran r = ran("flying_bar", all, "strain");
        EXPECT_EQ(r.verdict, "ok");
        EXPECT_LT(r.error, 1e-4) << scheme;  // as far again as it was strained at the start
    }
}
TEST(FlyingBar, RefusesWhatOnlyAFreeBarHas) {
    const Folder folder;
    expect_one_line(folder.run("flying_bar", {"--strain", "0.1"}), 2, {"--strain", "--into nothing"});
    expect_one_line(folder.run("flying_bar", {"--scheme", "usl", "--transfer", "apic"}), 2, {"--transfer apic", "tlmpm"});
    expect_one_line(folder.run("affine_motion", {"--transfer", "xpic"}), 2, {"--transfer xpic", "fmpm"});
}

TEST(ContrastBar, RunsByTheImprovedMpmAndByDomains) {
    for (const char* scheme : {"impm", "cpdi"}) {
        const Ran r = ran("contrast_bar", words(std::string("--contrast 100 --cells 32 --cfl 0.4 --scheme ") + scheme), "frequency");
        EXPECT_EQ(r.verdict, "ok");
        EXPECT_LT(r.error, 0.06) << scheme;  // a cell of the halves' length
    }
}
TEST(ContrastBar, UnequalParticlesHaveTheSameMass) {
    ContrastBar<false> bar;
    bar.outer_ppc = 8;
    double inner = 0, outer = 0, first = 0, last = 0;
    for (const auto& p : bar.particles<typename ContrastBar<false>::Law::template PointOf<Point<1>>>(10, 1)) {
        (p.material == 0 ? inner : outer) += p.m;
        if (first == 0) first = p.V0;
        last = p.V0;
    }
    EXPECT_NEAR(inner, bar.rho * bar.length / 2, 1e-12);
    EXPECT_NEAR(outer, inner, 1e-12);
    EXPECT_NEAR(first / last, 8, 1e-12);
}

}  // namespace
}  // namespace mpm::test
