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
    double largest = 1, half = 1, last = 1;  // rms difference of the two runs' velocities, over that at the start; after half the time
    double crossings = 0;          // of cell edges by a particle, on average
};

using SegmentBody = Body<1, Point<1>, Node<1>, NeoHookean, Tensor<1, Hat>, Flip>;

/// The segment with all particles shifted by `offset` cells.
inline std::vector<SegmentBody> segment_body(const Segment<false>& scene, int cells, int ppc, double offset = 0) {
    const Lattice<1> lattice = scene.lattice(cells, 1);
    auto points = scene.particles<Point<1>>(cells, ppc);
    for (auto& p : points) p.X[0] = p.x[0] += offset / cells;
    return {SegmentBody{{points, Grid<1, Node<1>>(lattice), scene.law()}, {lattice, {}}, {}}};
}

/// One period of the segment in steps of 0.2 h/c, c = sqrt(E/rho); random velocities up to `amplitude` of the largest one. A run whose
/// particles leave the grid has grown beyond all numbers. `offset` shifts all particles at the start [cells], less than they are from the
/// edges.
inline NoiseGrowth grow_noise(const ImpmChoice& choice, Segment<false> scene, int cells, int ppc, double amplitude, double offset = 0) {
    scene.force = "nodes";
    std::vector<SegmentBody> quiet = segment_body(scene, cells, ppc, offset), noisy = quiet;
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
            if (2 * k < steps) growth.half = growth.last;
        }
    } catch (const OutsideGrid&) {
        growth.largest = growth.last = std::numeric_limits<double>::infinity();
    }
    growth.crossings /= static_cast<double>(quiet[0].points.size());
    return growth;
}

}  // namespace mpm
