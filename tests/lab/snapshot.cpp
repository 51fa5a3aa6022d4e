// Snapshots' files: CSV, and legacy VTK read back by a strict reader of the format's version 3.0.
#include "lab/snapshot.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>

#include "lab/csv_read.hpp"
#include "lab/options.hpp"

namespace mpm {
namespace {

/// What a legacy file holds: its parts in the order and with the counts that the format asks for; anything else fails.
class Vtk {
public:
    explicit Vtk(const std::string& path) : text_(read_file(path)) {
        EXPECT_EQ(line(), "# vtk DataFile Version 3.0");
        title = line();
        EXPECT_LE(title.size(), 255u);  // 256 characters with the line's end
        EXPECT_EQ(line(), "BINARY");
        read_dataset();
        while (at_ < text_.size()) read_attribute();
    }
    std::string title, dataset;
    std::vector<double> points, origin, spacing;
    std::vector<int> dimensions, cells;
    std::string cell_kind;
    std::size_t count = 0;                                // of points
    std::map<std::string, std::vector<double>> scalars, vectors, tensors;

private:
    std::string line() {
        const std::size_t end = text_.find('\n', at_);
        if (end == std::string::npos) throw std::runtime_error("no line end");
        const std::string found = text_.substr(at_, end - at_);
        at_ = end + 1;
        return found;
    }
    template <class... Values> void words(const std::string& keyword, Values&... values) {
        std::istringstream in(line());
        std::string first, more;
        in >> first;
        EXPECT_EQ(first, keyword);
        ((in >> values), ...);
        EXPECT_TRUE(in) << keyword;
        EXPECT_FALSE(in >> more) << more << " after " << keyword;
    }
    std::uint64_t big_endian(std::size_t bytes) {
        if (at_ + bytes > text_.size()) throw std::runtime_error("the file ends within its numbers");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < bytes; ++i) bits = bits << 8 | static_cast<unsigned char>(text_[at_++]);
        return bits;
    }
    std::vector<double> doubles(std::size_t n) {
        std::vector<double> all;
        for (std::size_t i = 0; i < n; ++i) all.push_back(std::bit_cast<double>(big_endian(8)));
        EXPECT_EQ(line(), "");
        return all;
    }
    void read_dataset() {
        words("DATASET", dataset);
        std::string type;
        std::size_t n = 0;
        if (dataset == "POLYDATA") {
            words("POINTS", count, type);
            EXPECT_EQ(type, "double");
            points = doubles(3 * count);
            std::size_t size = 0;
            std::istringstream in(line());
            in >> cell_kind >> n >> size;
            EXPECT_TRUE(cell_kind == "VERTICES" || cell_kind == "POLYGONS") << cell_kind;
            for (std::size_t i = 0; i < size; ++i) cells.push_back(static_cast<std::int32_t>(big_endian(4)));
            EXPECT_EQ(line(), "");
            std::size_t place = 0;
            for (std::size_t i = 0; i < n; ++i) place += 1 + static_cast<std::size_t>(cells.at(place));
            EXPECT_EQ(place, size) << "size of the list of cells";
        } else {
            EXPECT_EQ(dataset, "STRUCTURED_POINTS");
            dimensions.resize(3), origin.resize(3), spacing.resize(3);
            words("DIMENSIONS", dimensions[0], dimensions[1], dimensions[2]);
            words("ORIGIN", origin[0], origin[1], origin[2]);
            words("SPACING", spacing[0], spacing[1], spacing[2]);
            count = static_cast<std::size_t>(dimensions[0] * dimensions[1] * dimensions[2]);
        }
        words("POINT_DATA", n);
        EXPECT_EQ(n, count);
    }
    void read_attribute() {
        std::istringstream in(line());
        std::string kind, name, type, more;
        in >> kind >> name >> type;
        EXPECT_EQ(type, "double");
        if (kind == "SCALARS") {
            int components = 0;
            EXPECT_TRUE(in >> components) << name;
            EXPECT_EQ(components, 1);
            EXPECT_EQ(line(), "LOOKUP_TABLE default");
            scalars[name] = doubles(count);
        } else if (kind == "VECTORS") {
            vectors[name] = doubles(3 * count);
        } else if (kind == "TENSORS") {
            tensors[name] = doubles(9 * count);
        } else {
            throw std::runtime_error("unknown attribute " + kind);
        }
        EXPECT_FALSE(in >> more) << more;
    }

    std::string text_;
    std::size_t at_ = 0;
};

struct Snapshots : testing::Test {
    std::string folder = testing::TempDir() + "mpm_snapshots_" + std::to_string(getpid());
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::string path(const std::string& name) const { return folder + "/" + name; }

    const Snapshot plane{{"body", "x", "y", "vx", "vy", "sxx", "syy", "sxy", "szz", "V", "plastic strain"},
                         {0, 0.1, 0.2, 1, -1, 10, 20, 3, 4, 0.5, 0.01,  //
                          1, 0.3, 0.4, 2, -2, 11, 21, 5, 6, 0.25, 1.0 / 3}};
};
using Values = std::vector<double>;

TEST_F(Snapshots, ReadBackFromCsvExactly) {
    write_csv(path("p.csv"), plane);
    const CsvTable table = read_csv(path("p.csv"));
    EXPECT_EQ(table.columns, plane.columns);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.number(1, "plastic strain"), 1.0 / 3);
    EXPECT_EQ(table.number(0, "syy"), 20);
}
TEST_F(Snapshots, OfNothingAreAHeader) {
    write_csv(path("p.csv"), Snapshot{{"x", "y"}});
    EXPECT_EQ(read_file(path("p.csv")), "x,y\n");
    write_vtk(path("p.vtk"), "none", Snapshot{{"x", "y"}});
    EXPECT_EQ(Vtk(path("p.vtk")).count, 0u);
}
TEST_F(Snapshots, AreVerticesWithVectorsAndTensorsInVtk) {
    write_vtk(path("p.vtk"), "particles, t = 0.5", plane);
    const Vtk vtk(path("p.vtk"));
    EXPECT_EQ(vtk.title, "particles, t = 0.5");
    EXPECT_EQ(vtk.points, (Values{0.1, 0.2, 0, 0.3, 0.4, 0}));
    EXPECT_EQ(vtk.cell_kind, "VERTICES");
    EXPECT_EQ(vtk.cells, (std::vector<int>{1, 0, 1, 1}));
    EXPECT_EQ(vtk.vectors.at("v"), (Values{1, -1, 0, 2, -2, 0}));
    EXPECT_EQ(vtk.tensors.at("sigma"), (Values{10, 3, 0, 3, 20, 0, 0, 0, 4, 11, 5, 0, 5, 21, 0, 0, 0, 6}));
    EXPECT_EQ(vtk.scalars.at("body"), (Values{0, 1}));
    EXPECT_EQ(vtk.scalars.at("plastic_strain"), (Values{0.01, 1.0 / 3})) << "names are one word";
    EXPECT_EQ(vtk.scalars.count("x"), 0u);
}
TEST_F(Snapshots, OfALineAreVerticesToo) {
    write_vtk(path("p.vtk"), "bar", Snapshot{{"body", "x", "v", "F", "sigma", "V"}, {0, 0.5, 2, 1.1, -7, 0.25}});
    const Vtk vtk(path("p.vtk"));
    EXPECT_EQ(vtk.points, (Values{0.5, 0, 0}));
    EXPECT_EQ(vtk.vectors.at("v"), (Values{2, 0, 0}));
    EXPECT_EQ(vtk.scalars.at("sigma"), (Values{-7}));
    EXPECT_EQ(vtk.tensors.at("sigma_tensor"), (Values{-7, 0, 0, 0, 0, 0, 0, 0, 0})) << "another name than the scalar's";
}
TEST_F(Snapshots, KeepNumbersThatAreNone) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    write_vtk(path("p.vtk"), "bad", Snapshot{{"x", "y", "q"}, {0, 0, nan, 1, 1, inf}});
    const auto q = Vtk(path("p.vtk")).scalars.at("q");
    EXPECT_TRUE(std::isnan(q[0]));
    EXPECT_EQ(q[1], inf);
}
TEST_F(Snapshots, KeepTheirTitleOnOneLine) {
    write_vtk(path("p.vtk"), "two\nlines " + std::string(400, 'x'), plane);
    EXPECT_TRUE(Vtk(path("p.vtk")).title.starts_with("two\\nlines"));
}
TEST_F(Snapshots, OfAMeshAreTriangles) {
    const Snapshot corners{{"x", "y", "q"}, {0, 0, 1, 1, 0, 2, 0, 1, 3, 1, 1, 4}};
    write_vtk(path("m.vtk"), "mesh", corners, {{{0, 1, 2}}, {{1, 3, 2}}});
    const Vtk vtk(path("m.vtk"));
    EXPECT_EQ(vtk.cell_kind, "POLYGONS");
    EXPECT_EQ(vtk.cells, (std::vector<int>{3, 0, 1, 2, 3, 1, 3, 2}));
    EXPECT_EQ(vtk.scalars.at("q"), (Values{1, 2, 3, 4}));
}
TEST_F(Snapshots, OfNodesAreAGridWithMassAndVelocity) {
    GridSnapshot grid{{{"body", "x", "y", "m", "mvx", "mvy"}}, {2, 3}, {-1, 0.5}, {0.5, 0.25}};
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 2; ++i) grid.add(std::array<double, 6>{0, -1 + 0.5 * i, 0.5 + 0.25 * j, 2.0 * i, 3.0 * i, -1.0 * i * j});
    write_vtk(path("n.vtk"), "nodes", grid);
    const Vtk vtk(path("n.vtk"));
    EXPECT_EQ(vtk.dimensions, (std::vector<int>{2, 3, 1}));
    EXPECT_EQ(vtk.origin, (Values{-1, 0.5, 0}));
    EXPECT_EQ(vtk.spacing, (Values{0.5, 0.25, 1}));
    EXPECT_EQ(vtk.scalars.at("m"), (Values{0, 2, 0, 2, 0, 2}));
    EXPECT_EQ(vtk.vectors.at("v"), (Values{0, 0, 0, 1.5, 0, 0, 0, 0, 0, 1.5, -0.5, 0, 0, 0, 0, 1.5, -1, 0})) << "no mass, no velocity";
}
TEST_F(Snapshots, OfNodesTellBodiesApart) {
    GridSnapshot grid{{{"body", "x", "m", "mv"}}, {2, 1}, {0, 0}, {1, 1}};
    for (int body = 0; body < 2; ++body)
        for (int i = 0; i < 2; ++i) grid.add(std::array<double, 4>{1.0 * body, 1.0 * i, 1.0 + body, 4.0 * i});
    write_vtk(path("n.vtk"), "nodes", grid);
    const Vtk vtk(path("n.vtk"));
    EXPECT_EQ(vtk.scalars.at("m_0"), (Values{1, 1}));
    EXPECT_EQ(vtk.scalars.at("m_1"), (Values{2, 2}));
    EXPECT_EQ(vtk.vectors.at("v_1"), (Values{0, 0, 0, 2, 0, 0}));
}
TEST_F(Snapshots, InTimeAreASeries) {
    write_vtk_series(path("p.vtk.series"), {{"particles_0000.vtk", 0}, {"particles_0001.vtk", 0.1}});
    EXPECT_EQ(read_file(path("p.vtk.series")),
              "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n    { \"name\" : \"particles_0000.vtk\", \"time\" : 0 },\n"
              "    { \"name\" : \"particles_0001.vtk\", \"time\" : 0.1 }\n  ]\n}\n");
}
TEST_F(Snapshots, SayWhereTheyCannotBeWritten) {
    EXPECT_THROW(write_csv(path("none/p.csv"), plane), FileTrouble);
    EXPECT_THROW(write_vtk(path("none/p.vtk"), "t", plane), FileTrouble);
}

}  // namespace
}  // namespace mpm
