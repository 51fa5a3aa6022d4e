/// What becomes of noise on the particles of the improved MPM: two runs of the manufactured segment, one with velocities perturbed at the
/// start, and how far they part.
#pragma once
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "chapters/explicit/flip.hpp"
#include "chapters/improved/impm.hpp"
#include "chapters/mms/segment.hpp"
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/tensor.hpp"

namespace mpm {

struct NoiseGrowth {
    double largest = 1, last = 1;  // rms difference of the velocities of the two runs, over that at the start
    double crossings = 0;          // of cell edges by a particle, on average
};

/// One period of the segment in steps of 0.2 h/c, c = sqrt(E/rho); random velocities up to `amplitude` of the largest one. A run whose
/// particles leave the grid has grown beyond all numbers.
inline NoiseGrowth grow_noise(const ImpmChoice& choice, Segment<false> scene, int cells, int ppc, double amplitude) {
    using Shape = Tensor<1, Hat>;
    using OneBody = Body<1, Point<1>, Node<1>, NeoHookean, Shape, Flip>;
    scene.force = "nodes";
    const Lattice<1> lattice = scene.lattice(cells, 1);
    const auto body = [&] {
        return std::vector<OneBody>{OneBody{{scene.particles<Point<1>>(cells, ppc), Grid<1, Node<1>>(lattice), scene.law()}, {lattice, {}}, {}}};
    };
    std::vector<OneBody> quiet = body(), noisy = body();
    std::mt19937 random(7);
    for (auto& p : noisy[0].points) p.v[0] += amplitude * scene.speed() * (static_cast<double>(random()) / 2147483648.0 - 1);
    const auto difference = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < quiet[0].points.size(); ++i) sum += (quiet[0].points[i].v - noisy[0].points[i].v).squaredNorm();
        return std::sqrt(sum / static_cast<double>(quiet[0].points.size()));
    };
    const double start = difference();
    const int steps = 10 * cells;
    const double dt = scene.period() / steps;
    Impm<1> first{choice}, second{choice};
    NoiseGrowth growth;
    try {
        for (int k = 0; k < steps; ++k) {
            const auto before = quiet[0].points;
            first.step(quiet, Free{}, scene, k * dt, dt);
            second.step(noisy, Free{}, scene, k * dt, dt);
            for (std::size_t i = 0; i < before.size(); ++i)
                if (std::floor(before[i].x[0] * cells) != std::floor(quiet[0].points[i].x[0] * cells)) ++growth.crossings;
            growth.last = difference() / start;
            if (!(growth.last <= growth.largest)) growth.largest = growth.last;
        }
    } catch (const OutsideGrid&) {
        growth.largest = growth.last = std::numeric_limits<double>::infinity();
    }
    growth.crossings /= static_cast<double>(quiet[0].points.size());
    return growth;
}

}  // namespace mpm
