/// Digital images: PGM and PPM (P2, P3, P5, P6, up to 16 bits) and PNG (any kind); and the particles made of them, one in each pixel
/// (review 4.1.3). Link target `image` (libpng behind image_png.cpp).
#pragma once
#include <array>
#include <string>
#include <vector>

#include "lab/fill.hpp"
#include "lab/math.hpp"
#include "lab/options.hpp"

namespace mpm {

/// Red, green and blue, each 0 ... 1; equal for grey.
using Colour = std::array<float, 3>;
inline Colour grey(double level) { return {static_cast<float>(level), static_cast<float>(level), static_cast<float>(level)}; }

struct Image {
    static constexpr double most = 1e8;  // pixels that are read
    int width = 0, height = 0;
    std::vector<Colour> pixels;  // row by row from the top, each from left to right

    Colour at(int column, int row) const {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
    }
};

/// Reads a PGM, PPM or PNG file, told apart by its first bytes. A level is the file's number over its largest; what is transparent is seen
/// on white. Throws FileTrouble, saying why, for a file that cannot be read as a whole.
Image read_image(const std::string& path);
/// Writes a binary PPM (P6) or a PNG, 8 bits a colour. Throws FileTrouble.
void write_ppm(const std::string& path, const Image& image);
void write_png(const std::string& path, const Image& image);

/// What a colour stands for; `material` < 0 is background, of which no particles are made.
struct Level {
    static constexpr int background = -1;
    Colour colour{};
    int material = 0;
};
/// A pixel's particle before it has a Point: centre, area [length^2], material.
struct Tagged {
    Vec<2> x;
    double V;
    int material;
};
struct TaggedPixels {
    std::vector<Tagged> pixels;
    long background = 0, unmatched = 0;  // pixels of the background; of colours too far from every level
};

/// The pixels of an image whose lower left corner is at `corner`, `size` wide and high each [length] (total width / image.width), row by
/// row from the bottom, each with the material of the nearest level (the first of equals). The distance of colours is the largest
/// difference of a component; beyond `tolerance` (to single precision) a pixel is left out and counted. Throws BadInput for an image
/// without pixels, no levels, a size that is not > 0 or a negative tolerance.
TaggedPixels tag_pixels(const Image& image, const std::vector<Level>& levels, double tolerance, const Vec<2>& corner, double size);

/// Particles of tagged pixels, m = rho V with rho by material; `material` is set where Point has one. Throws BadInput for a material
/// without a density.
template <class Point> std::vector<Point> particles_of(const std::vector<Tagged>& pixels, const std::vector<double>& rho) {
    std::vector<Point> all;
    for (const Tagged& pixel : pixels) {
        const auto material = static_cast<std::size_t>(pixel.material);
        if (material >= rho.size()) throw BadInput("image: material " + std::to_string(pixel.material) + " has no density");
        Point& p = all.emplace_back(particle_at<Point>(pixel.x, pixel.V, rho[material]));
        if constexpr (requires { p.material; }) p.material = pixel.material;
    }
    return all;
}

namespace detail {
/// Decodes the bytes of a PNG file; throws FileTrouble with the path.
Image decode_png(const std::string& bytes, const std::string& path);
/// The message for a file that is not the image it should be.
FileTrouble unreadable(const std::string& path, const std::string& why);
/// Throws for an image without pixels or with more than Image::most.
void check_size(double width, double height, const std::string& path);
}  // namespace detail

}  // namespace mpm
