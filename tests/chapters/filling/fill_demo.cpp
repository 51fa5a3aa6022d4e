// What fill_demo writes, and what it answers to bad polygons, images and options.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>

#include "lab/csv_read.hpp"
#include "lab/record.hpp"
#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

class FillDemo : public testing::Test {
protected:
    /// Runs it well, quietly and into `out`, and reads its table.
    CsvTable filled(Words words) {
        words.insert(words.end(), {"--out", "out", "--quiet"});
        const Ending ending = folder.run("fill_demo", words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        EXPECT_EQ(ending.out + ending.err, "");
        expect_readable_files(folder, "out");
        return read_csv(folder.path("out/filling.csv"));
    }
    CsvTable particles(const std::string& name) { return read_csv(folder.path("out/" + name)); }
    void write(const std::string& name, const std::string& text) { write_file(folder.path(name), text); }

    /// Refused in one line with these parts; nothing is written, nothing that was there is touched.
    void expect_refused(int code, Words words, const Words& parts) {
        SCOPED_TRACE(testing::PrintToString(words));
        const auto before = folder.listing();
        words.insert(words.end(), {"--out", "out"});
        expect_one_line(folder.run("fill_demo", words), code, parts);
        EXPECT_EQ(folder.listing(), before);
    }

    Folder folder;
};

double sum(const CsvTable& table, const std::string& column) {
    double total = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) total += table.number(i, column);
    return total;
}

// Review 6.1.2: 416 particles, kinetic energy 2.600, 2.5375, 2.5219 for 2.513 (NUMBERS.md section 1): ten times the area.
TEST_F(FillDemo, FillsTheReviewsTwoDisks) {
    const CsvTable table = filled({"--cells", "20,40,80"});
    ASSERT_EQ(table.rows.size(), 6u);
    EXPECT_EQ(table.text(0, "particles"), "416");
    const double areas[]{0.26, 0.25375, 0.2521875};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(table.number(2 * i, "mass"), areas[i], 1e-12);
        EXPECT_NEAR(table.number(2 * i, "mass_exact"), 2 * 3.14159265358979 * 0.04, 1e-12);
    }
    for (std::size_t i = 0; i < 6; ++i) EXPECT_LE(std::abs(table.number(i, "difference")), table.number(i, "bound"));
    const CsvTable points = particles("particles_mid.csv");
    EXPECT_EQ(points.rows.size(), 416u) << "of the first resolution";
    EXPECT_NEAR(sum(points, "m"), 0.26, 1e-12);
}
TEST_F(FillDemo, KeepsTheMassWhereTheSharedAreaIsExact) {
    for (const char* region : {"disks", "ring"}) {
        const CsvTable table = filled({"--region", region, "--weight", "share", "--cells", "7,30", "--rho", "3"});
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            EXPECT_NEAR(table.number(i, "mass"), table.number(i, "mass_exact"), 1e-12 * table.number(i, "mass_exact"));
            EXPECT_EQ(table.number(i, "bound"), 0);
        }
    }
}
TEST_F(FillDemo, StaysWithinItsBoundWhereItSamples) {
    const CsvTable table = filled({"--region", "plate", "--weight", "share", "--samples", "5", "--cells", "7,30"});
    for (std::size_t i = 0; i < table.rows.size(); ++i) EXPECT_LE(std::abs(table.number(i, "difference")), table.number(i, "bound"));
}
TEST_F(FillDemo, VisitsNineCellsForTheTriangle) {
    filled({"--case", "bounds"});
    EXPECT_EQ(sum(particles("cells.csv"), "visited"), 9);
    EXPECT_EQ(particles("particles.csv").rows.size() + particles("discarded.csv").rows.size(), 36u);
}
TEST_F(FillDemo, KeepsTheMassOfMeshes) {
    write("frame.txt", "0 0\n3 0\n3 2\n0 1\n\n1 .5\n1 1\n2 1\n");
    for (const Words& words : {Words{"--case", "mesh"}, Words{"--case", "mesh", "--polygon", "frame.txt", "--rho", "7"}}) {
        const CsvTable table = filled(words);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(table.number(i, "mass"), table.number(i, "mass_exact"), 1e-12 * table.number(i, "mass_exact"));
        EXPECT_EQ(table.number(1, "particles"), 3 * table.number(0, "particles"));
    }
    EXPECT_NEAR(filled({"--case", "mesh", "--polygon", "frame.txt"}).number(0, "mass_exact"), 4.25, 1e-12);
}
TEST_F(FillDemo, KeepsTheMassOfVoronoiCells) {
    write("frame.txt", "0 0\n3 0\n3 2\n0 1\n\n1 .5\n1 1\n2 1\n");
    for (const Words& words :
         {Words{"--case", "voronoi", "--seeds", "40"}, Words{"--case", "voronoi", "--polygon", "frame.txt", "--rho", "7"}}) {
        const CsvTable table = filled(words);
        ASSERT_EQ(table.rows.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(table.number(i, "mass"), table.number(i, "mass_exact"), 1e-12 * table.number(i, "mass_exact"));
        EXPECT_EQ(static_cast<double>(particles("particles_relaxed.csv").rows.size()), table.number(1, "particles"));
    }
}
TEST_F(FillDemo, ReadsBackTheImagesThatItMakes) {
    const CsvTable table = filled({"--case", "image", "--pixels", "50", "--width", "2"});
    const CsvTable points = particles("particles.csv");
    EXPECT_EQ(static_cast<double>(points.rows.size()), sum(table, "particles"));
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(table.number(i, "mass"), table.number(i, "mass_exact"), 1e-12 * table.number(i, "mass_exact"));
    EXPECT_NEAR(sum(points, "V"), 4 * 0.88 * 0.88, 1e-12) << "all but the margins of 3 pixels";
    for (const char* name : {"out/composite.ppm", "out/composite.png"}) {
        const std::string before = folder.read(name), path = folder.path("copy");
        write("copy", before);
        const CsvTable again =
            filled({"--case", "image", "--image", path, "--levels", "f2cc73,334d8c", "--background", "ffffff", "--width", "2"});
        for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(again.text(i, "particles"), table.text(i, "particles")) << name;
        filled({"--case", "image", "--pixels", "50", "--width", "2"});
    }
}
TEST_F(FillDemo, TagsAUsersGreyImage) {
    write("grey.pgm", "P2 3 2 255\n0 10 200\n255 128 60\n");
    const CsvTable table =
        filled({"--case", "image", "--image", "grey.pgm", "--levels", "0,200", "--background", "255", "--tolerance", "60"});
    EXPECT_EQ(table.text(0, "particles"), "3") << "0, 10, 60";
    EXPECT_EQ(table.text(1, "particles"), "1") << "200; 128 is too far from both";
}
TEST_F(FillDemo, IsRepeatedFromItsSettings) {
    for (const Words& words : {Words{"--case", "image", "--pixels", "20"}, Words{"--case", "mesh", "--size", "0.3", "--corners", "7"},
                               Words{"--case", "voronoi", "--seeds", "30", "--start", "5"}, Words{"--ppc", "3"}}) {
        filled(words);
        const std::string before = folder.read("out/filling.csv"), ini = folder.read("out/run.ini");
        write("again.ini", ini);
        filled({"--config", "again.ini"});
        EXPECT_EQ(folder.read("out/filling.csv"), before);
    }
}

TEST_F(FillDemo, RefusesOptionsOfOtherCases) {
    expect_refused(2, {"--case", "mesh", "--cells", "5"}, {"--cells", "--case cells"});
    expect_refused(2, {"--size", "0.2"}, {"--size", "--case mesh"});
    expect_refused(2, {"--case", "bounds", "--polygon", "x"}, {"--polygon", "--case cells, mesh or voronoi"});
    expect_refused(2, {"--samples", "4"}, {"--samples", "--weight share"});
    expect_refused(2, {"--case", "image", "--levels", "0,1"}, {"--levels", "--image"});
    expect_refused(2, {"--case", "mesh", "--seeds", "5"}, {"--seeds", "--case voronoi"});
    expect_refused(2, {"--case", "voronoi", "--size", "0.2"}, {"--size", "--case mesh"});
    expect_refused(2, {"--case", "voronoi", "--seeds", "0"}, {"--seeds = 0", "1 ... 5e+06"});
    expect_refused(2, {"--case", "image", "--ppc", "3"}, {"--ppc", "--case cells or bounds"});
    expect_refused(2, {"--case", "mesh", "--angle", "30"}, {"--angle = 30", "0 ... 20.7"});
    expect_refused(2, {"--case", "mesh", "--size", "1e-9"}, {"mesh: size = 1e-09 needs more than 5000000 triangles"});
}
TEST_F(FillDemo, RefusesBadPolygons) {
    const std::vector<std::pair<std::string, std::string>> bad{{"0,0\n1,1\n1,0\n0,1\n", "the outline crosses or touches itself"},
                                                               {"0,0\n1,1\n", "has 2 corners, at least 3"},
                                                               {"", "has 0 corners"},
                                                               {"0,0\n1,1\n2,2\n", "encloses no area"},
                                                               {"0,0\n1,0\n1,0\n0,1\n", "are the same, (1, 0)"},
                                                               {"0,0\n1,nan\n0,1\n", "is (1, nan)"},
                                                               {"0,0\n1,0\n0,1\n\n5,5\n6,5\n5,6\n", "hole 1 does not lie in"},
                                                               {"0,0\n1,0\n0,1\n\n0.1,0.1\n3,0.1\n0.1,0.2\n", "crosses or touches hole 1"}};
    filled({"--case", "mesh"});  // a run that no refused one may touch
    for (const auto& [text, why] : bad)
        for (const char* way : {"cells", "mesh"}) {
            write("bad.txt", text);
            expect_refused(2, {"--case", way, "--polygon", "bad.txt"}, {"bad.txt", why});
        }
    write("bad.txt", "0,0\n1,zero\n");
    expect_refused(1, {"--polygon", "bad.txt"}, {"line 2 is not x, y: 1,zero"});
    expect_refused(1, {"--polygon", "missing.txt"}, {"missing.txt", "No such file"});
    expect_refused(1, {"--polygon", "."}, {"it is a directory"});
}
TEST_F(FillDemo, TakesAClockwisePolygon) {
    write("clockwise.txt", "0,0\n0,1\n1,1\n1,0\n");
    EXPECT_NEAR(filled({"--polygon", "clockwise.txt"}).number(0, "mass"), 1, 1e-12);
    EXPECT_NEAR(filled({"--case", "mesh", "--polygon", "clockwise.txt"}).number(0, "mass"), 1, 1e-12);
}
TEST_F(FillDemo, RefusesBadImages) {
    filled({"--case", "image", "--pixels", "10"});
    const std::string png = folder.read("out/composite.png"), ppm = folder.read("out/composite.ppm");
    const std::vector<std::pair<std::string, std::string>> bad{{"", "it is empty"},
                                                               {"GIF89a", "it is no PGM or PPM"},
                                                               {ppm.substr(0, ppm.size() - 1), "it ends too early"},
                                                               {png.substr(0, png.size() / 2), "PNG: "},
                                                               {"P2 0 3 255\n", "0 x 3 pixels"},
                                                               {"P2 99999 99999 255\n1", "at most 1e+08"},
                                                               {"P2 1 1 0\n0", "largest level is 0"},
                                                               {"P2 1 1 9\nx", "not a whole number: x"}};
    for (const auto& [bytes, why] : bad) {
        write("bad.png", bytes);
        expect_refused(1, {"--case", "image", "--image", "bad.png"}, {"cannot read 'bad.png'", why});
    }
    expect_refused(1, {"--case", "image", "--image", "missing.png"}, {"missing.png", "No such file"});
    expect_refused(1, {"--case", "image", "--image", "."}, {"it is a directory"});
    write("good.pgm", "P2 1 1 9 3");
    for (const std::string levels : {"256", "12345g", "-1", "0,,1", "0,", "x"})
        expect_refused(2, {"--case", "image", "--image", "good.pgm", "--levels", levels}, {"--levels = ", "rrggbb"});
}
TEST_F(FillDemo, SaysWhenItCannotWrite) {
    write("out", "in the way");
    expect_one_line(folder.run("fill_demo", {"--out", "out"}), 1, {"cannot make the folder out"});
    EXPECT_EQ(folder.read("out"), "in the way");
}

}  // namespace
}  // namespace mpm::test
