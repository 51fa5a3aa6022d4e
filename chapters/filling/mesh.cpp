// Particles of a triangle mesh: at centroids and at Gauss points, each with its share of the area (review figure 35).
#include "lab/mesh.hpp"

#include <algorithm>
#include <cstdio>

#include "chapters/filling/filling.hpp"
#include "lab/figure.hpp"
#include "lab/program.hpp"

namespace mpm::filling {
Filled fill_mesh(const Settings& set, const std::string& folder) {
    const bool disk = set.polygon.empty();
    const Polygon domain = disk ? Polygon(circle({0.5, 0.5}, 0.5, set.corners)) : read_polygon(set.polygon);
    const Triangles mesh = refine(domain, set.size, set.angle);
    const auto centroids = particles_at_centroids<Particle>(mesh, set.rho), gauss = particles_at_gauss_points<Particle>(mesh, set.rho);

    Filled filled;
    const double exact = set.rho * domain.area();
    filled.rows = {row_of("centroids", 0, centroids, exact, 0), row_of("gauss", 0, gauss, exact, 0)};
    char text[160];
    std::snprintf(text, sizeof text, "%zu triangles of %zu points, smallest angle %.1f degrees", mesh.corners.size(), mesh.points.size(),
                  smallest_angle(mesh));
    filled.notes.push_back(text);
    if (disk) {
        std::snprintf(text, sizeof text, "the disk's area is %.3e larger than that of its %d corners",
                      Disk{{0, 0}, 0.5}.area() - domain.area(), set.corners);
        filled.notes.push_back(text);
    }
    make_folder(folder);
    write_particles(folder + "/particles_centroids.csv", centroids, filled.files);
    write_particles(folder + "/particles_gauss.csv", gauss, filled.files);
    write_segments(folder + "/mesh.csv", edges_of(mesh), filled.files);
    const double across = (domain.bounds().high - domain.bounds().low).maxCoeff();
    filled.files.push_back(write_drawing(
        folder, "fill_mesh", 1500, 800,
        std::string(panels) + "size = " +
            number_text(std::clamp(12 * std::sqrt(domain.area() / static_cast<double>(mesh.corners.size())) / across, 0.1, 1.3)) +
            R"(
unset grid
do for [k in 'centroids gauss'] {
    set title (k eq 'gauss' ? 'three Gauss points in each triangle' : 'one particle at each centroid')
    plot 'mesh.csv' using (column('x')):(column('y')):(column('dx')):(column('dy')) with vectors nohead dt solid lc rgb '#7fa8d1' lw 1, \
         'particles_'.k.'.csv' using (column('x')):(column('y')) with points pt 7 ps (k eq 'gauss' ? 0.6 * size : size) lc rgb 'black'
}
unset multiplot
)"));
    return filled;
}

}  // namespace mpm::filling
