#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>

#include "lab/image.hpp"
#include "lab/record.hpp"

namespace mpm {
namespace {

/// libpng answers trouble with longjmp, over which no object may be destroyed: all that it may be met in lives outside of the functions
/// that set jumps.
struct Png {
    const std::string* bytes = nullptr;  // of the file that is read
    std::size_t at = 0;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string trouble;
    int width = 0, height = 0, channels = 0, depth = 0;
    std::vector<png_byte> samples;
    std::vector<png_bytep> rows;

    void make_rows() {
        const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) * static_cast<std::size_t>(depth / 8);
        samples.resize(row * static_cast<std::size_t>(height));
        for (std::size_t i = 0; i < static_cast<std::size_t>(height); ++i) rows.push_back(samples.data() + i * row);
    }
};

[[noreturn]] void note_error(png_structp png, png_const_charp text) {
    static_cast<Png*>(png_get_error_ptr(png))->trouble = text;
    png_longjmp(png, 1);
}
void note_warning(png_structp, png_const_charp) {}  // of parts that do not change the pixels

void take_bytes(png_structp png, png_bytep to, std::size_t n) {
    auto* file = static_cast<Png*>(png_get_io_ptr(png));
    if (file->bytes->size() - file->at < n) png_error(png, "it ends too early");
    std::memcpy(to, file->bytes->data() + file->at, n);
    file->at += n;
}

bool read_size(Png& file) {
    if (setjmp(png_jmpbuf(file.png)) != 0) return false;
    png_set_read_fn(file.png, &file, take_bytes);
    png_set_user_limits(file.png, 0x7fffffff, 0x7fffffff);
    png_read_info(file.png, file.info);
    file.width = static_cast<int>(png_get_image_width(file.png, file.info));
    file.height = static_cast<int>(png_get_image_height(file.png, file.info));
    return true;
}
/// Turns every kind into 8 or 16 bits of grey or RGB, with alpha where there is transparency.
bool choose_kind(Png& file) {
    if (setjmp(png_jmpbuf(file.png)) != 0) return false;
    png_set_expand(file.png);
    png_set_interlace_handling(file.png);
    png_read_update_info(file.png, file.info);
    file.channels = png_get_channels(file.png, file.info);
    file.depth = png_get_bit_depth(file.png, file.info);
    return true;
}
bool read_rows(Png& file) {
    if (setjmp(png_jmpbuf(file.png)) != 0) return false;
    png_read_image(file.png, file.rows.data());
    png_read_end(file.png, nullptr);
    return true;
}

bool write_all(Png& file, std::FILE* to) {
    if (setjmp(png_jmpbuf(file.png)) != 0) return false;
    png_init_io(file.png, to);
    png_set_IHDR(file.png, file.info, static_cast<png_uint_32>(file.width), static_cast<png_uint_32>(file.height), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(file.png, file.info);
    png_write_image(file.png, file.rows.data());
    png_write_end(file.png, nullptr);
    return true;
}

/// One pixel on white.
Colour colour_of(const Png& file, std::size_t pixel) {
    const auto sample = [&](int channel) {
        const std::size_t i = pixel * static_cast<std::size_t>(file.channels) + static_cast<std::size_t>(channel);
        if (file.depth == 8) return static_cast<float>(file.samples[i]) / 255.0f;
        return static_cast<float>(256 * file.samples[2 * i] + file.samples[2 * i + 1]) / 65535.0f;
    };
    const bool colour = file.channels > 2;
    const float alpha = file.channels % 2 == 0 ? sample(file.channels - 1) : 1.0f;
    Colour c{};
    for (int i = 0; i < 3; ++i) c[static_cast<std::size_t>(i)] = alpha * sample(colour ? i : 0) + (1.0f - alpha);
    return c;
}

}  // namespace

Image detail::decode_png(const std::string& bytes, const std::string& path) {
    Png file;
    file.bytes = &bytes;
    file.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &file, note_error, note_warning);
    const std::unique_ptr<Png, void (*)(Png*)> cleaner(&file, [](Png* f) { png_destroy_read_struct(&f->png, &f->info, nullptr); });
    file.info = file.png != nullptr ? png_create_info_struct(file.png) : nullptr;
    if (file.info == nullptr) throw std::bad_alloc();
    const auto must = [&](bool done) {
        if (!done) throw unreadable(path, "PNG: " + file.trouble);
    };
    must(read_size(file));
    check_size(file.width, file.height, path);
    must(choose_kind(file));
    file.make_rows();
    must(read_rows(file));

    Image image{file.width, file.height, {}};
    image.pixels.resize(static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = colour_of(file, i);
    return image;
}

void write_png(const std::string& path, const Image& image) {
    Png file;
    file.width = image.width;
    file.height = image.height;
    file.channels = 3;
    file.depth = 8;
    file.make_rows();
    for (std::size_t i = 0; i < file.samples.size(); ++i)
        file.samples[i] = static_cast<png_byte>(std::lround(255 * std::min(1.0f, std::max(0.0f, image.pixels[i / 3][i % 3]))));
    replace_file(path, [&](const std::string& part) {
        file.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &file, note_error, note_warning);
        const std::unique_ptr<Png, void (*)(Png*)> cleaner(&file, [](Png* f) { png_destroy_write_struct(&f->png, &f->info); });
        file.info = file.png != nullptr ? png_create_info_struct(file.png) : nullptr;
        if (file.info == nullptr) return ENOMEM;
        std::FILE* to = std::fopen(part.c_str(), "wb");
        if (to == nullptr) return errno;
        errno = 0;
        const bool whole = write_all(file, to);
        const int error = whole ? 0 : errno != 0 ? errno : EIO;
        return std::fclose(to) != 0 && error == 0 ? errno : error;
    });
}

}  // namespace mpm
