// Particles of an image: one at the centre of each pixel, tagged with the material of its colour (review figure 36).
#include "lab/image.hpp"

#include <charconv>
#include <cstdio>

#include "chapters/filling/composite.hpp"
#include "chapters/filling/filling.hpp"
#include "lab/figure.hpp"
#include "lab/program.hpp"

namespace mpm::filling {
namespace {

/// "rrggbb" in hexadecimal digits, or a grey level 0 ... 255. Throws BadInput.
Colour read_colour(const std::string& text, const std::string& option) {
    const bool rgb = text.size() == 6;
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, rgb ? 16 : 10);
    if (error != std::errc() || end != text.data() + text.size() || (!rgb && value > 255))
        throw BadInput("--" + option + " = " + one_line(text) + ": allowed grey levels 0 ... 255 and colours rrggbb in hexadecimal digits");
    if (!rgb) return grey(value / 255.0);
    Colour colour{};
    for (std::size_t i = 0; i < 3; ++i) colour[i] = static_cast<float>((value >> (16 - 8 * i)) & 255u) / 255.0f;
    return colour;
}

/// Materials 0, 1, ... by the colours of --levels, and the background.
std::vector<Level> levels_of(const Settings& set) {
    if (set.image.empty()) return composite_levels();
    std::vector<Level> levels;
    for (std::size_t from = 0; !set.levels.empty() && from <= set.levels.size();) {
        const std::size_t comma = std::min(set.levels.find(',', from), set.levels.size());
        levels.push_back({read_colour(set.levels.substr(from, comma - from), "levels"), static_cast<int>(levels.size())});
        from = comma + 1;
    }
    if (levels.empty()) levels = {{grey(0), 0}, {grey(1), 1}};
    if (set.background != "none") levels.push_back({read_colour(set.background, "background"), Level::background});
    return levels;
}

/// Writes the test image in both forms and reads them back: they must be what was written.
Image written_and_read(const Image& image, const std::string& folder, std::vector<std::string>& files) {
    const std::string ppm = folder + "/composite.ppm", png = folder + "/composite.png";
    write_ppm(ppm, image);
    write_png(png, image);
    files.insert(files.end(), {ppm, png});
    for (const std::string& path : {ppm, png})
        if (read_image(path).pixels != image.pixels) throw FileTrouble("'" + path + "' does not hold what was written");
    return read_image(png);
}

void write_pixels(const std::string& path, const Image& image, double size, std::vector<std::string>& files) {
    Csv<5> file(path, {"x", "y", "r", "g", "b"});
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const Colour c = image.at(column, row);
            file.row((column + 0.5) * size, (image.height - row - 0.5) * size, 255 * c[0], 255 * c[1], 255 * c[2]);
        }
    files.push_back(path);
}

constexpr const char* drawing = R"(set multiplot layout 1,3
set size ratio -1
unset key
unset grid
set tics out nomirror
set xlabel 'x [length]'
set ylabel 'y [length]'
set xrange [0:w]
set yrange [0:h]
colour(k) = word('#e69f00 #0072b2 #000000 #009e73 #cc79a7 #d55e00', k % 6 + 1)
set title 'image'
plot 'pixels.csv' using (column('x')):(column('y')):(column('r')):(column('g')):(column('b')) with rgbimage
set title 'particles'
set key below horizontal samplen 0.5
plot for [k=0:materials-1] 'particles.csv' using (column('x')):(column('material') == k ? column('y') : NaN) with points pt 7 \
     ps 75.0 / (w / dx) lc rgb colour(k) notitle, \
     for [k=0:materials-1] NaN with points pt 7 ps 1.5 lc rgb colour(k) title sprintf('material %d', k)
unset key
set title 'zoom'
set xrange [zx:zx + 16*dx]
set yrange [zy:zy + 16*dx]
set format '%.3g'
plot 'particles.csv' using (column('x') - dx/2):(column('y') - dx/2):(dx):(0) with vectors nohead dt solid lw 1 lc rgb '#c8c8c8', \
     '' using (column('x') - dx/2):(column('y') - dx/2):(0):(dx) with vectors nohead dt solid lw 1 lc rgb '#c8c8c8', \
     for [k=0:materials-1] '' using (column('x')):(column('material') == k ? column('y') : NaN) with points pt 7 ps 1.6 lc rgb colour(k)
unset multiplot
)";

}  // namespace

Filled fill_image(const Settings& set, const std::string& folder) {
    const std::vector<Level> levels = levels_of(set);
    Image image = set.image.empty() ? composite(set.pixels) : read_image(set.image);
    const double size = set.width / image.width;
    const TaggedPixels tagged = tag_pixels(image, levels, set.tolerance / 255, Vec<2>::Zero(), size);
    const int materials = static_cast<int>(levels.size()) - (levels.back().material < 0 ? 1 : 0);
    const auto particles = particles_of<Particle>(tagged.pixels, std::vector<double>(static_cast<std::size_t>(materials), set.rho));

    Filled filled;
    for (int material = 0; material < materials; ++material) {
        std::vector<Particle> some;
        for (const Particle& p : particles)
            if (p.material == material) some.push_back(p);
        const double exact = set.rho * static_cast<double>(some.size()) * size * size;
        filled.rows.push_back(row_of(std::string("material ").append(std::to_string(material)), 0, some, exact, 0));
    }
    filled.notes.push_back(std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels, " +
                           std::to_string(tagged.background) + " of the background, " + std::to_string(tagged.unmatched) +
                           " too far from every level");
    make_folder(folder);
    if (set.image.empty()) image = written_and_read(image, folder, filled.files);
    write_pixels(folder + "/pixels.csv", image, size, filled.files);
    write_particles(folder + "/particles.csv", particles, filled.files);
    const double height = size * image.height;
    filled.files.push_back(write_drawing(folder, "fill_image", 1800, 680,
                                         "w = " + number_text(set.width) + "; h = " + number_text(height) + "; dx = " + number_text(size) +
                                             "; zx = " + number_text(size * (2 * image.width / 5)) +
                                             "; zy = " + number_text(size * (2 * image.height / 5)) +
                                             "; materials = " + std::to_string(materials) + "\n" + drawing));
    return filled;
}

}  // namespace mpm::filling
