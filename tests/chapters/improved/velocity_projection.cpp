// Which transfers give a linear velocity field to the nodes and take it back, and what velocity_projection writes and answers.
#include "chapters/improved/velocity_projection.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "chapters/improved/affine.hpp"
#include "chapters/improved/fmpm.hpp"
#include "lab/csv_read.hpp"

namespace mpm::test {
namespace {

using projection::Projected;
using projection::Settings;

Settings settings(int cells, int ppc, double jitter = 0) {
    Settings set;
    set.cells = cells;
    set.ppc = ppc;
    set.jitter = jitter;
    return set;
}
double worst(const Projected& p) { return std::max({p.nodes.middle, p.nodes.ends, p.particles.middle, p.particles.ends}); }

// Review figure 55: three cells of size 2, a particle in the middle of each.
TEST(VelocityProjection, LumpedMassHasTheReviewsErrors) {
    const Projected p = projection::project<Hat>(settings(3, 1), Flip{0});
    ASSERT_EQ(p.node_v.size(), 4u);
    EXPECT_DOUBLE_EQ(p.node_v[0], 1);
    EXPECT_DOUBLE_EQ(p.node_v[1], 2);
    EXPECT_DOUBLE_EQ(p.node_v[2], 4);
    EXPECT_DOUBLE_EQ(p.node_v[3], 5);
    EXPECT_DOUBLE_EQ(p.nodes.middle, 0);
    EXPECT_DOUBLE_EQ(p.nodes.ends, 0.5);
    EXPECT_DOUBLE_EQ(p.particles.ends, 0.25);
}

// The end node has the mean of its particles, sum (1 - r) r / sum (1 - r); that of a continuum is 1/3.
TEST(VelocityProjection, LumpedMassMissesTheEndByTheMeanOfItsParticles) {
    for (int ppc = 1; ppc <= 5; ++ppc) {
        double mass = 0, momentum = 0;
        for (const double r : middles(ppc).at) mass += 1 - r, momentum += (1 - r) * r;
        EXPECT_NEAR(projection::project<Hat>(settings(6, ppc), Flip{0}).nodes.ends, momentum / mass, 1e-14) << ppc;
    }
    EXPECT_NEAR(projection::project<Hat>(settings(6, 100), Flip{0}).nodes.ends, 1.0 / 3, 1e-4);
}

template <class Kernel>
class EveryShape : public testing::Test {};
using Kernels = testing::Types<Hat, Ugimp, Cpgimp, Quadratic, Cubic, Bernstein>;
TYPED_TEST_SUITE(EveryShape, Kernels);

TYPED_TEST(EveryShape, AffineConsistentAndMlsKeepALinearField) {
    for (const double jitter : {0.0, 0.8}) {
        const Settings set = settings(12, 3, jitter);
        Consistent<false> consistent;
        consistent.alpha = 0;
        EXPECT_LT(worst(projection::project<TypeParam>(set, Apic<false>{})), 1e-12);
        EXPECT_LT(worst(projection::project<TypeParam>(set, consistent)), 1e-12);
        EXPECT_LT(worst(projection::project<TypeParam>(set, projection::Mls{{0}})), 1e-12);
    }
}
TYPED_TEST(EveryShape, LumpedMassKeepsItInsideForEvenParticlesOnly) {
    const Projected even = projection::project<TypeParam>(settings(12, 2), Flip{0});
    EXPECT_LT(even.nodes.middle, 1e-12);
    EXPECT_GT(even.nodes.ends, 0.29);  // measured .30 (bernstein) to .46 (cubic)
    EXPECT_GT(even.particles.ends, 0.16);
    EXPECT_GT(projection::project<TypeParam>(settings(12, 3, 0.8), Flip{0}).nodes.middle, 0.03);
}
TYPED_TEST(EveryShape, FmpmMendsItTermByTerm) {
    const Settings set = settings(12, 3, 0.8);
    const Projected lumped = projection::project<TypeParam>(set, Flip{0});
    double last = worst(projection::project<TypeParam>(set, Fmpm{1}));
    EXPECT_NEAR(last, worst(lumped), 1e-14) << "one term is the lumped mass";
    for (const int order : {2, 4, 8, 16, 32}) {
        const double now = worst(projection::project<TypeParam>(set, Fmpm{order}));
        EXPECT_LT(now, 0.75 * last) << order;
        last = now;
    }
}
TYPED_TEST(EveryShape, FinerCellsDoNotMendTheEnds) {
    const double coarse = projection::project<TypeParam>(settings(12, 2), Flip{0}).nodes.ends;
    EXPECT_NEAR(projection::project<TypeParam>(settings(48, 2), Flip{0}).nodes.ends, coarse, 1e-9);
}

TEST(VelocityProjection, WhatHasNoAnswerIsNotANumber) {
    const Projected p = projection::project<Hat>(settings(3, 1), Consistent<false>{});
    EXPECT_EQ(p.verdict, "singular: 4 nodes, 3 particles");
    EXPECT_TRUE(std::isnan(p.nodes.middle) && std::isnan(p.particles.ends));
}
TEST(VelocityProjection, RefusesParticlesOutsideTheBody) {
    Settings set = settings(12, 2, 0.5);
    set.offset = 0.12;
    EXPECT_EQ(projection::places(set).size(), 24u);
    set.offset = 0.13;
    EXPECT_THROW(projection::places(set), BadInput);
}

class ProjectionProgram : public ::testing::Test {
protected:
    const std::string folder = ::testing::TempDir() + "mpm_projection_" + std::to_string(getpid());
    void TearDown() override { std::filesystem::remove_all(folder); }
    int run(const std::string& options) const {
        const int status =
            std::system((MPM_BUILD_DIR "/velocity_projection --quiet --out " + folder + " " + options + " 2>" + folder + ".err").c_str());
        std::filesystem::remove(folder + ".err");
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
};

TEST_F(ProjectionProgram, WritesEveryPairByName) {
    ASSERT_EQ(run("--ppc 3"), 0);
    const CsvTable table = read_csv(folder + "/projection.csv");
    EXPECT_EQ(table.rows.size(), AllShapes::names().size() * 5);
    for (std::size_t i = 0; i < table.rows.size(); ++i) EXPECT_EQ(table.text(i, "verdict"), "ok") << table.text(i, "shape");
    for (const std::string& shape : AllShapes::names()) {
        const CsvTable nodes = read_csv(folder + "/nodes_" + shape + ".csv"), particles = read_csv(folder + "/particles_" + shape + ".csv");
        EXPECT_EQ(particles.rows.size(), 36u);
        for (std::size_t i = 0; i < nodes.rows.size(); ++i)
            EXPECT_NEAR(nodes.number(i, "v_apic"), nodes.number(i, "v_exact"), 1e-12) << shape;
        EXPECT_NEAR(nodes.number(0, "error_flip"), nodes.number(0, "v_flip") / 0.5, 1e-15);
    }
    for (const char* file : {"run.ini", "velocity_projection.gp"}) EXPECT_TRUE(std::filesystem::exists(folder + "/" + file)) << file;
}
TEST_F(ProjectionProgram, IsRepeatedFromItsSettings) {
    ASSERT_EQ(run("--shape cubic --transfer fmpm --order 7 --jitter 0.4 --pad 2"), 0);
    const std::string before = read_file(folder + "/projection.csv");
    ASSERT_EQ(run("--config " + folder + "/run.ini"), 0);
    EXPECT_EQ(read_file(folder + "/projection.csv"), before);
}
TEST_F(ProjectionProgram, AnswersWrongInput) {
    EXPECT_EQ(run("--cells 2"), 2);
    EXPECT_EQ(run("--transfer pic"), 2);
    EXPECT_EQ(run("--transfer apic --order 3"), 2);
    EXPECT_EQ(run("--offset 0.4"), 2) << "particles outside the body";
    EXPECT_FALSE(std::filesystem::exists(folder));
    EXPECT_EQ(run("--help"), 0);
}

}  // namespace
}  // namespace mpm::test
