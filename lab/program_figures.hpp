/// The figures of every program. For lab/program.cpp only.
#pragma once
#include <string>
#include <vector>

#include "lab/program.hpp"

namespace mpm {

/// What the scene watches, the energies and, in 2D, the momentum against time. Adds what it writes to `files`.
void history_figure(const Description& about, const Common& common, const Assembled& assembled, const RunResult& result,
                    const std::string& folder, std::vector<std::string>& files);

/// Whether a picture of particles is asked for: an animation or, in 2D, one of a few snapshots. It is drawn from CSV.
bool shows_particles(const Common& common, const Assembled& assembled);

/// The snapshots of a run: how to animate them and, in 2D, a picture of a few of them. Adds what it writes to `files`.
void particle_figures(const Description& about, const Common& common, const Assembled& assembled, const RunResult& result,
                      const std::string& folder, std::vector<std::string>& files);

}  // namespace mpm
