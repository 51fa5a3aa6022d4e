// The programs of heat as a user runs them: what they refuse, and how they end.
#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

TEST(HeatPrograms, RefuseWhatMeansNothing) {
    const Folder folder;
    expect_one_line(folder.run("heat_bar", {"--flux", "2"}), 2, {"--flux", "--case flux", "held"});
    expect_one_line(folder.run("heat_bar", {"--case", "flux", "--flux", "0"}), 2, {"--flux", "0"});
    expect_one_line(folder.run("heat_bar", {"--T1", "0"}), 2, {"--T1", "T0"});
    expect_one_line(folder.run("heat_plate", {"--smooth"}), 2, {"--smooth", "stress"});
    expect_one_line(folder.run("heat_bar", {"--k", "-1"}), 2, {"--k", "-1", "> 0"});
    EXPECT_TRUE(folder.empty());
}

TEST(HeatPrograms, NameTheirInstability) {
    const Folder folder;
    const Ending ending = folder.run("heat_bar", {"--k", "1e6", "--dt", "8e-5", "--t-end", "0.05", "--out", "run"});
    EXPECT_EQ(ending.code, 3);
    EXPECT_TRUE(holds(ending.out, "temperature-growth"));
    EXPECT_TRUE(holds(ending.out, "h^2/(2 kappa)"));
    const auto summary = csv(folder.read("run/summary.csv"));
    EXPECT_EQ(field(summary, 1, "verdict"), "unstable:temperature-growth");
    EXPECT_EQ(field(summary, 1, "error"), "nan");
}

TEST(HeatPrograms, WriteReadableFiles) {
    const Folder folder;
    EXPECT_EQ(folder.run("heat_plate", {"--cells", "8", "--frames", "1", "--out", "run", "--quiet"}).code, 0);
    EXPECT_GE(expect_readable_files(folder, "run"), 5);
    EXPECT_EQ(folder.run("heat_plate", {"--cells", "8", "--frames", "1", "--format", "vtk", "--out", "vtk", "--quiet"}).code, 0);
    EXPECT_TRUE(holds(folder.read("vtk/nodes_0001.vtk"), "SCALARS T"));
    EXPECT_FALSE(holds(folder.read("vtk/particles_0001.vtk"), "VECTORS"));
}

}  // namespace
}  // namespace mpm::test
