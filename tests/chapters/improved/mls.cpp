// Moving least squares: what a basis can hold is reproduced, on any grid; what points do not tell lowers the degree, and is counted.
#include "chapters/improved/mls.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "lab/csv_read.hpp"

namespace mpm::test {
namespace {

template <int D> struct Known {
    Vec<D> x;
    double u;
};

/// `ppc`^D random points in every cell of a grid of cells of size h, its lower corner at `corner`.
template <int D> std::vector<Known<D>> random_points(const Lattice<D>& lattice, int ppc) {
    std::mt19937 random(5);
    std::vector<Known<D>> all;
    for (int j = 0; j < (D == 2 ? lattice.cells(1) : 1); ++j)
        for (int i = 0; i < lattice.cells(0); ++i)
            for (int q = 0; q < power(ppc, D); ++q) {
                Known<D> p{Vec<D>::Zero(), 0};
                for (int d = 0; d < D; ++d)
                    p.x[d] = lattice.origin()[d] + ((d == 0 ? i : j) + static_cast<double>(random()) / 4294967296.0) * lattice.h()[d];
                all.push_back(p);
            }
    return all;
}

/// A polynomial of the given degree with coefficients of order one in coordinates of order one.
template <int D> double polynomial(const Vec<D>& s, int degree) {
    double u = 0.7;
    if (degree > 0) u += 1.3 * s[0] - (D == 2 ? 0.9 * s[D - 1] : 0);
    if (degree > 1) u += 0.8 * s[0] * s[0] + (D == 2 ? 1.1 * s[0] * s[D - 1] - 0.6 * s[D - 1] * s[D - 1] : 0);
    return u;
}

/// Largest error at all nodes of a grid of 6 cells a side with random points.
template <int D> double error_at_nodes(const MlsChoice& choice, double h, double corner, MlsCounts& counts, int ppc = 3) {
    std::array<int, D> cells;
    cells.fill(6);
    const Lattice<D> lattice(Vec<D>::Constant(corner), Vec<D>::Constant(h), cells);
    const auto s = [&](const Vec<D>& x) { return Vec<D>((x - lattice.origin()) / (6 * h)); };
    auto points = random_points<D>(lattice, ppc);
    for (auto& p : points) p.u = polynomial<D>(s(p.x), choice.degree);
    NearPoints<D> near;
    near.fill(lattice, points);
    double largest = 0;
    for (int I = 0; I < lattice.size(); ++I) {
        const Vec<D> x = lattice.position(I);
        const auto fit = mls_at<1>(choice, near, points, x, [](const Known<D>& p) { return Vec<1>(p.u); });
        counts.see(fit.degree, choice);
        if (fit.degree == choice.degree) largest = std::max(largest, std::abs(fit.values[0] - polynomial<D>(s(x), choice.degree)));
    }
    return largest;
}

template <int D> void expect_basis_reproduced() {
    for (const bool quartic : {false, true})
        for (const int degree : {0, 1, 2})
            for (double h = 1; h > 0.5e-6; h /= 10) {
                MlsCounts counts;
                // Rounding grows at most by 1/sqrt(least) = 100 with each degree: 1e-16 times 1e4.
                EXPECT_LT(error_at_nodes<D>({degree, 2, quartic}, h, 0, counts), 1e-12) << "h = " << h << ", degree " << degree;
                EXPECT_EQ(counts.lower, 0);
            }
}
TEST(Mls, ReproducesItsBasisOnALineForEveryCellSize) { expect_basis_reproduced<1>(); }
TEST(Mls, ReproducesItsBasisInThePlaneForEveryCellSize) { expect_basis_reproduced<2>(); }

TEST(Mls, HasNoUnits) {
    for (const double unit : {1e-9, 1e9}) {
        MlsCounts counts;
        EXPECT_LT(error_at_nodes<2>({2, 2, false}, unit, 0, counts), 1e-12) << unit;
        EXPECT_EQ(counts.lower, 0);
    }
}
// A body a thousand cells from the origin: distances are differences of places, of which 3 digits are lost, and no more.
TEST(Mls, LosesFarFromTheOriginWhatPlacesLose) {
    MlsCounts counts;
    EXPECT_LT(error_at_nodes<2>({1, 2, false}, 1, 1000, counts), 1e-12);
    EXPECT_LT(error_at_nodes<2>({2, 2, false}, 1e-6, 1e-3, counts), 1e-11);
}

TEST(Mls, WeightsAreSplines) {
    for (const auto weight : {cubic_weight, quartic_weight}) {
        EXPECT_EQ(weight(1), 0);
        EXPECT_EQ(weight(1.5), 0);
        for (const double r : {0.5, 1.0}) EXPECT_NEAR(weight(r - 1e-9), weight(r + 1e-9), 1e-8);
        for (const double r : {0.5, 1.0})  // slopes, to the differences' own error
            EXPECT_NEAR((weight(r) - weight(r - 1e-6)) / 1e-6, (weight(r + 1e-6) - weight(r)) / 1e-6, 1e-4);
        EXPECT_NEAR((weight(1e-6) - weight(0)) / 1e-6, 0, 1e-4);
    }
    EXPECT_DOUBLE_EQ(cubic_weight(0), 2.0 / 3);
    EXPECT_NEAR(cubic_weight(0.75), 4.0 / 3 - 4 * 0.75 + 4 * 0.75 * 0.75 - 4.0 / 3 * 0.75 * 0.75 * 0.75, 1e-15);  // as printed
    EXPECT_DOUBLE_EQ(quartic_weight(0.25), 1 - 6 / 16.0 + 8 / 64.0 - 3 / 256.0);
}

template <int D> auto fit_of(const MlsChoice& choice, const std::vector<Known<D>>& points, const Vec<D>& x) {
    std::array<int, D> cells;
    cells.fill(4);
    NearPoints<D> near;
    near.fill(Lattice<D>(Vec<D>::Zero(), Vec<D>::Ones(), cells), points);
    return mls_at<1>(choice, near, points, x, [](const Known<D>& p) { return Vec<1>(p.u); });
}

TEST(MlsFallback, NoPointsIsNoFit) {
    const auto fit = fit_of<1>({1, 1.1, false}, {{Vec<1>(3.5), 1}}, Vec<1>(1.0));
    EXPECT_EQ(fit.degree, -1);
    EXPECT_EQ(fit.values[0], 0);
}
TEST(MlsFallback, OnePointGivesItsValue) {
    const auto fit = fit_of<2>({2, 1.5, false}, {{Vec<2>(2.5, 1.5), 7}}, Vec<2>(2, 2));
    EXPECT_EQ(fit.degree, 0);
    EXPECT_DOUBLE_EQ(fit.values[0], 7);
}
TEST(MlsFallback, PointsOnALineGiveTheirMean) {
    const std::vector<Known<2>> row{{Vec<2>(1.5, 1.9), 1}, {Vec<2>(2.0, 1.9), 2}, {Vec<2>(2.5, 1.9), 3}};
    const auto fit = fit_of<2>({1, 1.5, false}, row, Vec<2>(2, 2));
    EXPECT_EQ(fit.degree, 0) << "nothing is known across the line";
    EXPECT_NEAR(fit.values[0], 2, 1e-15);
}
TEST(MlsFallback, PointsTooCloseToEachOtherMakeNoLine) {
    const auto fit = [](double apart) { return fit_of<1>({1, 1.1, false}, {{Vec<1>(1.5), 0}, {Vec<1>(1.5 + apart), 1}}, Vec<1>(1.0)); };
    EXPECT_EQ(fit(0.3).degree, 1);
    EXPECT_EQ(fit(1e-4).degree, 0) << "would be extrapolated to " << -0.5 / 1e-4;
    EXPECT_LE(fit(1e-4).values[0], 1);
    EXPECT_EQ(fit(0).degree, 0);
}
TEST(MlsFallback, TwoDegreesLowerWhereFewPointsAre) {
    const std::vector<Known<1>> two{{Vec<1>(1.6), 1.6}, {Vec<1>(2.3), 2.3}};
    const auto fit = fit_of<1>({2, 1.5, false}, two, Vec<1>(2.0));
    EXPECT_EQ(fit.degree, 1);
    EXPECT_NEAR(fit.values[0], 2, 1e-14);
}
// Two points at 1.5 and 2 tell of a place at 1 with the weights 2 and -1: their noise is amplified.
TEST(MlsFallback, FarBeyondThePointsIsNoExtrapolation) {
    const std::vector<Known<1>> two{{Vec<1>(1.5), 1}, {Vec<1>(2.0), 2}};
    EXPECT_NEAR(fit_of<1>({1, 1.1, false, 1e4}, two, Vec<1>(1.0)).values[0], 0, 1e-12);  // amplified rounding
    EXPECT_EQ(fit_of<1>({1, 1.1, false, 12}, two, Vec<1>(1.0)).degree, 0);
    EXPECT_EQ(fit_of<1>({1, 1.1, false, 12}, two, Vec<1>(1.4)).degree, 1);
}
TEST(MlsFallback, IsCounted) {
    MlsCounts counts;
    error_at_nodes<2>({2, 0.6, false}, 1, 0, counts, 1);  // a point a cell: few nodes see six within 0.6 cells
    EXPECT_EQ(counts.fits, 49);
    EXPECT_GT(counts.lower, 40);
    EXPECT_GT(counts.none, 0);
    EXPECT_LT(counts.none, counts.lower);
}

TEST(NearPoints, RefusesPointsOutside) {
    const std::vector<Known<1>> points{{Vec<1>(4.1), 0}};
    EXPECT_THROW(fit_of<1>({}, points, Vec<1>(1.0)), OutsideGrid);
}
TEST(NearPoints, FindsAllAroundAnEdge) {
    const std::vector<Known<2>> points{{Vec<2>(0, 0), 0}, {Vec<2>(4, 4), 1}, {Vec<2>(1, 1), 2}, {Vec<2>(1 - 1e-15, 1), 3}};
    NearPoints<2> near;
    near.fill(Lattice<2>(Vec<2>::Zero(), Vec<2>::Ones(), {4, 4}), points);
    const auto seen = [&](const Vec<2>& x) {
        std::vector<std::size_t> all;
        near.visit(x, Vec<2>::Constant(0.5), [&](std::size_t i) { all.push_back(i); });
        std::sort(all.begin(), all.end());
        return all;
    };
    EXPECT_EQ(seen(Vec<2>(0, 0)), (std::vector<std::size_t>{0}));
    EXPECT_EQ(seen(Vec<2>(1, 1)), (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_EQ(seen(Vec<2>(4, 4)), (std::vector<std::size_t>{1}));
}

// The program, as a user runs it: review figures 98 and 99.
class MlsProgram : public ::testing::Test {
protected:
    const std::string folder = ::testing::TempDir() + "mpm_mls_" + std::to_string(getpid());
    void TearDown() override { std::filesystem::remove_all(folder); }
    int run(const std::string& options) const {
        const std::string command = MPM_BUILD_DIR "/mls_approximation --quiet --out " + folder + " " + options + " 2>/dev/null";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
};
TEST_F(MlsProgram, TheLinearBasisKeepsALinearFunctionTheConstantOneDoesNot) {
    ASSERT_EQ(run(""), 0);
    const CsvTable table = read_csv(folder + "/convergence.csv");
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_GT(table.number(0, "l2"), 0.02);
    EXPECT_LT(table.number(1, "largest"), 1e-13);  // a few roundings of values near one
    EXPECT_EQ(table.number(1, "lower"), 0);
}
// Two of these 15 points all but coincide, and one node sees no others.
TEST_F(MlsProgram, CountsTheFitsOfALowerDegree) {
    ASSERT_EQ(run("--seed 1"), 0);
    const CsvTable table = read_csv(folder + "/convergence.csv");
    EXPECT_EQ(table.number(1, "lower"), 1);
    EXPECT_EQ(table.number(1, "none"), 0);
}
TEST_F(MlsProgram, ConvergesWithOrderTwo) {
    ASSERT_EQ(run("--function sine --points 0 --cells 20,80,320,1280"), 0);
    const CsvTable table = read_csv(folder + "/convergence.csv");
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.text(row, "basis") == "linear" && row > 2) { EXPECT_NEAR(table.number(row, "order"), 2, 0.1); }  // random points
        if (table.text(row, "basis") == "quadratic" && row > 2) { EXPECT_GT(table.number(row, "order"), 2.9); }
    }
}
TEST_F(MlsProgram, AnswersWrongInput) {
    EXPECT_EQ(run("--function cosine"), 2);
    EXPECT_EQ(run("--support 0"), 2);
    EXPECT_FALSE(std::filesystem::exists(folder));
}

}  // namespace
}  // namespace mpm::test
