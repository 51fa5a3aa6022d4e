// Images: what is read is what was written, what cannot be read is refused, and pixels become particles.
#include "lab/image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "chapters/explicit/point.hpp"
#include "lab/csv_read.hpp"
#include "lab/options.hpp"
#include "lab/record.hpp"
#include "tests/lab/png_kinds.hpp"

namespace mpm::test {
namespace {

class ImageFile : public testing::Test {
protected:
    const std::string path = testing::TempDir() + "mpm_image";
    void TearDown() override { std::filesystem::remove(path); }
    Image read(const std::string& bytes) const {
        write_file(path, bytes);
        return read_image(path);
    }
    /// The grey levels, by rows, in parts of `largest`.
    std::vector<int> greys(const Image& image, int largest) const {
        std::vector<int> all;
        for (const Colour& c : image.pixels) all.push_back(static_cast<int>(std::lround(static_cast<float>(largest) * c[0])));
        return all;
    }
    void expect_refused(const std::string& bytes, const std::string& why) const {
        try {
            read(bytes);
            ADD_FAILURE() << "read: " << one_line(bytes);
        } catch (const FileTrouble& bad) {
            const std::string said = bad.what();
            EXPECT_NE(said.find("cannot read '" + path + "': "), std::string::npos) << said;
            EXPECT_NE(said.find(why), std::string::npos) << said;
            EXPECT_EQ(said, one_line(said, 1000)) << "one line";
        }
    }
};

Image pattern(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        image.pixels.push_back(
            {static_cast<float>(i % 256) / 255, static_cast<float>(7 * i % 256) / 255, static_cast<float>(31 * i % 256) / 255});
    return image;
}

TEST_F(ImageFile, KeepsWhatWasWritten) {
    for (const auto& [width, height] : {std::pair(1, 1), {3, 2}, {17, 40}, {256, 3}}) {
        const Image image = pattern(width, height);
        for (const auto write : {write_ppm, write_png}) {
            write(path, image);
            const Image back = read_image(path);
            EXPECT_EQ(back.width, width);
            EXPECT_EQ(back.height, height);
            EXPECT_EQ(back.pixels, image.pixels);
        }
    }
}
TEST_F(ImageFile, MayBeAPlainOrBinaryPgm) {
    EXPECT_EQ(greys(read("P2\n# by hand\n3 2 # size\n7\n0 1 2\n3 4 7\n"), 7), (std::vector<int>{0, 1, 2, 3, 4, 7}));
    EXPECT_EQ(greys(read("P2 1 1 1 1"), 1), std::vector<int>{1});
    EXPECT_EQ(greys(read(std::string("P5 3 1 255\n\x00\x80\xff", 14)), 255), (std::vector<int>{0, 128, 255}));
    EXPECT_EQ(greys(read(std::string("P5\n2 1\n65535\n\x01\x02\xff\xff", 17)), 65535), (std::vector<int>{258, 65535}));
}
TEST_F(ImageFile, MayBeAPlainOrBinaryPpm) {
    const Image plain = read("P3 2 1 100\n100 0 50   0 25 100");
    EXPECT_EQ(plain.pixels, (std::vector<Colour>{{1, 0, 0.5f}, {0, 0.25f, 1}}));
    EXPECT_EQ(read("P6\n#c\n1 1\n255\n\xff\x33\x66").pixels, (std::vector<Colour>{{1, 0.2f, 0.4f}}));
}
TEST_F(ImageFile, IsRefusedAsAPnmWithTheReason) {
    expect_refused("", "it is empty");
    expect_refused("P", "it is no PGM");
    expect_refused("P7\nWIDTH 2", "it is no PGM or PPM");
    expect_refused("P1 1 1 0", "it is no PGM or PPM");
    expect_refused("GIF89a\x01\n", "it starts with GIF89a\\x01");
    expect_refused("P5x1 1 1", "it is no PGM or PPM");
    expect_refused("P2 ", "it ends before its width");
    expect_refused("P2 4", "it ends before its height");
    expect_refused("P2 4 4", "it ends before its largest level");
    expect_refused("P2 a 4 5 1", "its width is not a whole number: a");
    expect_refused("P2 -3 4 5 1", "its width is not a whole number: -3");
    expect_refused("P2 2.5 4 5 1", "its width is not a whole number: 2.5");
    expect_refused("P2 99999999999 4 5 1", "its width is not a whole number");
    expect_refused("P2 0 4 5 1", "an image of 0 x 4 pixels");
    expect_refused("P5 2000000000 2000000000 255 \n", "2e+09 x 2e+09 pixels, at most 1e+08");
    expect_refused("P5 9000 9000 255\nabc", "it ends too early: 81000000 levels need 81000000 bytes, it has 3");
    expect_refused("P2 2 2 0\n0 0 0 0", "its largest level is 0, allowed 1 ... 65535");
    expect_refused("P2 2 2 65536\n0 0 0 0", "its largest level is 65536");
    expect_refused("P2 2 2 9\n0 1 2    ", "it ends before its level");
    expect_refused("P2 2 2 9\n0 1 2 x", "its level is not a whole number: x");
    expect_refused("P2 2 2 9\n0 1 2 10", "a level is 10, its largest should be 9");
    expect_refused("P2 2 2 9\n0 1 2 3 4", "more follows its last pixel");
    expect_refused("P5 2 1 9\n\x01\x0a", "a level is 10");
    expect_refused("P6 2 1 255\nabcde", "it ends too early");
    expect_refused("P6 2 1 255\nabcdefg", "more follows");
    expect_refused("P5 2 1 300\nabc", "it ends too early");
}
TEST_F(ImageFile, MustBeAFile) {
    EXPECT_THROW(read_image(path + ".missing"), FileTrouble);
    EXPECT_THROW(read_image(testing::TempDir()), FileTrouble);
    EXPECT_THROW(write_png("/nowhere/x.png", pattern(1, 1)), FileTrouble);
    EXPECT_THROW(write_ppm("/nowhere/x.ppm", pattern(1, 1)), FileTrouble);
}

/// Each byte of a PNG cut off or changed: an error, or (in what does not say how pixels look) the same image.
TEST_F(ImageFile, IsRefusedAsAPngThatIsCutOrChanged) {
    const Image image = pattern(9, 7);
    write_png(path, image);
    const std::string whole = read_file(path);
    for (std::size_t n = 1; n < whole.size(); ++n) expect_refused(whole.substr(0, n), n < 4 ? "it is no PGM" : "PNG: ");
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string changed = whole;
        changed[i] = static_cast<char>(changed[i] ^ 0x55);
        expect_refused(changed, "");
    }
}
TEST_F(ImageFile, IsRefusedAsAPngOfAbsurdSize) {
    std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\xff\xff\xff\0\xff\xff\xff\x08\x02\0\0\0", 29);
    unsigned crc = 0xffffffffu;
    for (std::size_t i = 12; i < head.size(); ++i) {
        crc ^= static_cast<unsigned char>(head[i]);
        for (int k = 0; k < 8; ++k) crc = (crc & 1u) != 0 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    for (int shift = 24; shift >= 0; shift -= 8) head += static_cast<char>((~crc >> shift) & 255u);
    expect_refused(head + std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12), "16777215 x 16777215 pixels, at most 1e+08 in all are read");
}

TEST_F(ImageFile, MayBeAPngOfAnyKind) {
    for (const PngKind& kind : png_kinds()) {
        SCOPED_TRACE(kind.name);
        const Image image = read(std::string(kind.bytes.begin(), kind.bytes.end()));
        ASSERT_EQ(image.pixels.size(), kind.pixels.size());
        for (std::size_t i = 0; i < kind.pixels.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(image.pixels[i][c], kind.pixels[i][c], 1e-6) << i;  // single precision
    }
}

const std::vector<Level> black_and_grey{{grey(0), 0}, {grey(0.5), 1}, {grey(1), Level::background}};
Image levels(int width, std::vector<double> values) {
    Image image{width, static_cast<int>(values.size()) / width, {}};
    for (const double v : values) image.pixels.push_back(grey(v));
    return image;
}

struct Fibre : Point<2> {
    int material = -1;
};
TEST(Pixels, BecomeParticlesAtTheirCentres) {
    const Image image = levels(3, {0, 0.5, 1, 0.45, 0.1, 0});
    const TaggedPixels tagged = tag_pixels(image, black_and_grey, 1, Vec<2>(10, 20), 2);
    EXPECT_EQ(tagged.background, 1);
    EXPECT_EQ(tagged.unmatched, 0);
    const auto points = particles_of<Fibre>(tagged.pixels, {3, 5});
    ASSERT_EQ(points.size(), 5u);
    EXPECT_EQ(points[0].x, Vec<2>(11, 21)) << "the lower left pixel is the first of the last row";
    EXPECT_EQ(points[4].x, Vec<2>(13, 23));
    const int materials[]{1, 0, 0, 0, 1};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(points[i].material, materials[i]);
        EXPECT_EQ(points[i].V0, 4);
        EXPECT_EQ(points[i].m, materials[i] == 0 ? 12 : 20);
    }
    EXPECT_EQ(particles_of<Point<2>>(tagged.pixels, {3, 5}).size(), 5u) << "a point without a material is fine";
}
TEST(Pixels, HaveTheMassOfTheImage) {
    std::vector<double> values(400 * 300);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 7 < 3 ? 0 : 0.5;
    const auto tagged = tag_pixels(levels(400, values), black_and_grey, 0.01, Vec<2>(0, 0), 0.3 / 400);
    double mass = 0;
    for (const auto& p : particles_of<Point<2>>(tagged.pixels, {2, 2})) mass += p.m;
    EXPECT_NEAR(mass, 2 * 0.3 * 0.225, 1e-12 * mass);
}
TEST(Pixels, AreLeftOutAndCountedBeyondTheTolerance) {
    const TaggedPixels tagged = tag_pixels(levels(5, {0, 0.1, 0.2, 0.3, 0.5}), black_and_grey, 0.15, Vec<2>(0, 0), 1);
    EXPECT_EQ(tagged.pixels.size(), 3u);
    EXPECT_EQ(tagged.unmatched, 2);
}
TEST(Pixels, AreTakenAtTheToleranceItself) {
    for (int level = 0; level <= 255; ++level)
        for (const int tolerance : {0, 1, 60, 255})
            for (const int at : {std::max(0, level - tolerance), std::min(255, level + tolerance)}) {
                const Image image = levels(1, {at / 255.0});
                EXPECT_EQ(tag_pixels(image, {{grey(level / 255.0), 0}}, tolerance / 255.0, Vec<2>(0, 0), 1).unmatched, 0)
                    << level << ' ' << tolerance;
            }
    EXPECT_EQ(tag_pixels(levels(1, {61.0 / 255}), {{grey(0), 0}}, 60.0 / 255, Vec<2>(0, 0), 1).unmatched, 1);
}
TEST(Pixels, AreToldApartByColour) {
    Image image{3, 1, {{0.9f, 0.1f, 0.1f}, {0.1f, 0.8f, 0.2f}, {0.2f, 0.2f, 0.9f}}};
    const auto tagged = tag_pixels(image, {{{0, 0, 1}, 0}, {{0, 1, 0}, 1}, {{1, 0, 0}, 2}}, 0.3, Vec<2>(0, 0), 1);
    ASSERT_EQ(tagged.pixels.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(tagged.pixels[i].material, 2 - static_cast<int>(i));
}
TEST(Pixels, AreRefusedWithoutSizeLevelsOrDensity) {
    const Image image = levels(1, {0});
    EXPECT_THROW(tag_pixels(Image{}, black_and_grey, 1, Vec<2>(0, 0), 1), BadInput);
    EXPECT_THROW(tag_pixels(image, {}, 1, Vec<2>(0, 0), 1), BadInput);
    for (const double bad : {0.0, -1.0, std::nan("")}) EXPECT_THROW(tag_pixels(image, black_and_grey, 1, Vec<2>(0, 0), bad), BadInput);
    for (const double bad : {-1.0, std::nan("")}) EXPECT_THROW(tag_pixels(image, black_and_grey, bad, Vec<2>(0, 0), 1), BadInput);
    EXPECT_THROW(particles_of<Point<2>>(tag_pixels(levels(1, {0.5}), black_and_grey, 1, Vec<2>(0, 0), 1).pixels, {1}), BadInput);
}

}  // namespace
}  // namespace mpm::test
