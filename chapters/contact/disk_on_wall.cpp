/// disk_on_wall: an elastic disk meets a rigid wall, a plane or particles, at rest or moving (rigid_wall.hpp, bardenhagen.hpp; review
/// 5.1.5).
///   ./disk_on_wall --cells 10,20,40
///   ./disk_on_wall --wall particles --along 0.5 --mu 0.2 --plot png
#include "chapters/contact/bardenhagen.hpp"
#include "chapters/explicit/flip.hpp"
#include "chapters/explicit/musl.hpp"
#include "chapters/scenes/disk_on_wall.hpp"
#include "chapters/weighting/assemble_with.hpp"
#include "lab/traits.hpp"

namespace {

using namespace mpm;
constexpr const char* program = "disk_on_wall";
constexpr const char* purpose = "an elastic disk meets a rigid wall";

RigidWall<2> floor_of(const DiskOnWall& scene, int cells) {
    RigidWall<2> wall;
    wall.motion.v0 = Vec<2>(0, scene.wall_speed);
    if (scene.wall == "plane") {
        wall.normal = Vec<2>(0, 1);
        return wall;
    }
    const Lattice<2> lattice = scene.lattice(cells, 1);
    wall.spacing = 0.5 / cells;
    for (double x = lattice.origin()[0] + wall.spacing / 2; x < lattice.upper()[0]; x += wall.spacing)
        for (const int row : {0, 1}) wall.X.emplace_back(x, -(row + 0.5) * wall.spacing);
    return wall;
}

int run(int argc, char** argv) {
    Options options(program, purpose);
    DiskOnWall disk;
    ContactChoice contact;
    contact.contact = "frictionless";
    Common common;
    common.cells = {20};
    common.ppc = 3;
    common.cfl = 0.2;
    common.records = 400;
    disk.declare(options);
    contact.declare(options);
    common.declare(options, {Hat::name}, 0.4, traits_of(disk));
    options.parse(argc, argv);
    if (answered(options, program)) return 0;
    if (!(disk.closing() > 0)) throw BadInput("--wall-speed: the wall must not fly ahead of the disk, allowed > -v0");
    disk.t_end = common.t_end;
    using Scene = DiskOnWall;
    const Panel velocity{"",
                         "t",
                         "time t [time]",
                         "velocity of the disk [length/time]",
                         {{"speed", "computed", "lines dt solid lc rgb '#c03030'"},
                          {"speed_rigid", "rebound at once", "lines dt 2 lc rgb 'black'"}},
                         ""};
    const Description about{program, purpose, Scene::name, Scene::solves, {Scene::columns.begin(), Scene::columns.end()}, 0, {velocity}};
    return run_program(about, options, common, [&](int cells) {
        Scene scene = disk;
        scene.log = std::make_shared<ContactLog<2>>();
        const Bardenhagen<2> coupling(contact, {floor_of(scene, cells)}, scene.log);
        return assemble_with<Hat, false>(Musl{}, scene, Flip{}, cells, common, coupling);
    });
}

}  // namespace

int main(int argc, char** argv) {
    return guarded(program, [&] { return run(argc, argv); });
}
