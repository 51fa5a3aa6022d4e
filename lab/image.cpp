#include "lab/image.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "lab/csv_read.hpp"
#include "lab/record.hpp"

namespace mpm {

FileTrouble detail::unreadable(const std::string& path, const std::string& why) {
    return FileTrouble("cannot read '" + one_line(path, 300) + "': " + why);
}

void detail::check_size(double width, double height, const std::string& path) {
    const std::string size = number_text(width) + " x " + number_text(height) + " pixels";
    if (!(width > 0 && height > 0)) throw unreadable(path, "an image of " + size);
    if (!(width * height <= Image::most)) throw unreadable(path, size + ", at most " + number_text(Image::most) + " in all are read");
}

namespace {

/// Numbers of a PGM or PPM file, with blanks and comments between.
class Numbers {
public:
    Numbers(std::string_view text, const std::string& path) : text_(text), path_(path) {}

    /// The next number, called `what` in messages.
    int next(const char* what) {
        skip();
        if (at_ == text_.size()) throw detail::unreadable(path_, std::string("it ends before its ") + what);
        int value = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error != std::errc() || value < 0 || (end != text_.data() + text_.size() && !blank(*end) && *end != '#'))
            throw detail::unreadable(path_, std::string("its ") + what + " is not a whole number: " + word());
        at_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }
    /// What follows the one blank behind the last number.
    std::string_view rest() const { return text_.substr(std::min(at_ + 1, text_.size())); }
    bool more() {
        skip();
        return at_ < text_.size();
    }

private:
    static bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    void skip() {
        for (; at_ < text_.size() && (blank(text_[at_]) || text_[at_] == '#'); ++at_)
            if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size() - 1);
    }
    std::string word() const { return one_line(text_.substr(at_, text_.find_first_of(" \t\r\n", at_) - at_), 20); }

    std::string_view text_;
    const std::string& path_;
    std::size_t at_ = 2;  // behind the magic number
};

Image decode_pnm(const std::string& bytes, const std::string& path) {
    Numbers numbers(bytes, path);
    const bool plain = bytes[1] < '5', colour = bytes[1] == '3' || bytes[1] == '6';
    Image image;
    image.width = numbers.next("width");
    image.height = numbers.next("height");
    detail::check_size(image.width, image.height, path);
    const int largest = numbers.next("largest level");
    if (largest < 1 || largest > 65535)
        throw detail::unreadable(path, "its largest level is " + std::to_string(largest) + ", allowed 1 ... 65535");

    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                      samples = pixels * (colour ? 3 : 1);
    const std::string_view raster = numbers.rest();
    const std::size_t width = largest > 255 ? 2 : 1, needed = plain ? 2 * samples - 1 : width * samples;  // bytes, at least
    if (raster.size() < needed)
        throw detail::unreadable(path, "it ends too early: " + std::to_string(samples) + " levels need " + std::to_string(needed) +
                                           " bytes, it has " + std::to_string(raster.size()));
    if (!plain && raster.find_first_not_of(" \t\r\n", needed) != std::string_view::npos)
        throw detail::unreadable(path, "more follows its last pixel");
    std::size_t at = 0;
    const auto byte = [&] { return static_cast<int>(static_cast<unsigned char>(raster[at++])); };
    const auto level = [&] {
        const int high = !plain && width == 2 ? byte() : 0;
        const int value = plain ? numbers.next("level") : 256 * high + byte();
        if (value > largest)
            throw detail::unreadable(path, "a level is " + std::to_string(value) + ", its largest should be " + std::to_string(largest));
        return static_cast<float>(value) / static_cast<float>(largest);
    };
    image.pixels.resize(pixels);
    for (Colour& pixel : image.pixels) {
        pixel[0] = level();
        pixel[1] = colour ? level() : pixel[0];
        pixel[2] = colour ? level() : pixel[0];
    }
    if (plain && numbers.more()) throw detail::unreadable(path, "more follows its last pixel");
    return image;
}

/// Single precision: far below a step of 16 bits, 1.5e-5.
constexpr double rounding = 1e-6;

/// The nearest level, or none within the tolerance.
const Level* nearest_level(const Colour& colour, const std::vector<Level>& levels, double tolerance) {
    const Level* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Level& level : levels) {
        double distance = 0;
        for (std::size_t i = 0; i < 3; ++i)
            distance = std::max(distance, std::abs(static_cast<double>(colour[i]) - static_cast<double>(level.colour[i])));
        if (distance < least && distance <= tolerance + rounding) nearest = &level, least = distance;
    }
    return nearest;
}

}  // namespace

Image read_image(const std::string& path) {
    const std::string bytes = read_file(path);
    if (bytes.empty()) throw detail::unreadable(path, "it is empty");
    if (bytes.starts_with("\x89PNG")) return detail::decode_png(bytes, path);
    const bool pnm = bytes.size() > 2 && bytes[0] == 'P' && std::string_view("2356").find(bytes[1]) != std::string_view::npos &&
                     std::string_view(" \t\r\n#").find(bytes[2]) != std::string_view::npos;
    if (!pnm)
        throw detail::unreadable(path,
                                 "it is no PGM or PPM (P2, P3, P5, P6) and no PNG: it starts with " + one_line(bytes.substr(0, 8), 8));
    return decode_pnm(bytes, path);
}

void write_ppm(const std::string& path, const Image& image) {
    std::string text = "P6\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
    for (const Colour& pixel : image.pixels)
        for (const float c : pixel) text += static_cast<char>(std::lround(255 * std::clamp(c, 0.0f, 1.0f)));
    write_file(path, text);
}

TaggedPixels tag_pixels(const Image& image, const std::vector<Level>& levels, double tolerance, const Vec<2>& corner, double size) {
    if (image.width < 1 || image.height < 1) throw BadInput("image: it has no pixels");
    if (levels.empty()) throw BadInput("image: no level stands for a material");
    if (!(size > 0) || !std::isfinite(size)) throw BadInput("image: pixel size = " + number_text(size) + ": allowed > 0");
    if (!(tolerance >= 0)) throw BadInput("image: tolerance = " + number_text(tolerance) + ": allowed >= 0");
    TaggedPixels tagged;
    for (int row = image.height - 1; row >= 0; --row)
        for (int column = 0; column < image.width; ++column) {
            const Level* level = nearest_level(image.at(column, row), levels, tolerance);
            if (level == nullptr)
                ++tagged.unmatched;
            else if (level->material < 0)
                ++tagged.background;
            else
                tagged.pixels.push_back({corner + size * Vec<2>(column + 0.5, image.height - 1 - row + 0.5), size * size, level->material});
        }
    return tagged;
}

}  // namespace mpm
