/// The one run loop: whole steps, a stopwatch around the method only, records, the watch for instability, the verdict.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "lab/clock.hpp"
#include "lab/figure.hpp"
#include "lab/monitor.hpp"
#include "lab/snapshot.hpp"

namespace mpm {

/// One assembled problem as the loop sees it: called once a step or once a record, so that the loop is compiled once.
struct Simulation {
    std::function<void(double t, double dt)> step;               // the method, all that is timed
    std::function<Measures()> measure;                           // energies and momentum now
    std::function<Trouble()> check;                              // every step: is any particle beyond repair?
    std::function<Trouble()> inspect;                            // every record: numerical fracture and the like
    std::function<std::string()> where;                          // which particle is the fastest
    std::function<Supply(double t, double dt)> supply;           // every step: what came in from outside; empty if nothing can
    std::function<double()> critical_dt;                         // h/(c + |v|) now
    std::function<void(double t, double energy)> sample;         // every step: the scene's observer
    std::function<bool(double t)> wants_energy;                  // whether `sample` wants the energy at t
    std::function<std::vector<double>(double t)> watch;          // the scene's own history columns
    std::function<Snapshot()> particles;
    std::function<GridSnapshot()> nodes;
    std::function<Snapshot()> domains;                           // corners of the particles' domains; empty if they have none
    std::function<void()> keep;                                  // remember this state as good
    std::function<void()> restore;                               // go back to the last good state
    bool any_step = false;                                       // the method is implicit: h/(c + |v|) does not limit its step
};

/// What the steps of a scene in motion are measured by.
inline constexpr const char* wave_limit = "h/(c + |v|)";

struct RunPlan {
    double dt = 0, t_end = 0;
    double cfl = 0;                              // > 0: dt = cfl h/(c + |v|) afresh every step (review 2.7)
    long steps = 0;                              // whole steps of dt to t_end; an estimate with `cfl`
    int records = 1000, frames = 0;
    SnapshotFormat particles{}, nodes{};         // files of snapshots
    bool stop_on_trouble = true;
    std::string folder;                          // where history and snapshots go
    std::vector<std::string> columns;            // names of `watch`
    int dim = 1;
    double critical_dt = 0;                      // h/(c + |v|) at the start, to name a likely cause
    std::string limit = wave_limit;              // what critical_dt is
    bool progress = false;
};

struct RunResult {
    Trouble trouble;
    bool stopped = false;                         // before t_end, by trouble or by an interrupt
    double t_fail = 0, t = 0;
    long steps = 0;
    double wall = 0, cpu = 0;
    double energy_drift = 0;                      // change of energy less work, relative to the energy in play
    double momentum_drift = 0;                    // change of momentum less impulse, relative to the larger of sum m |v| and impulse
    bool interrupted = false;
    std::vector<Frame> frames;                    // snapshots written
    double momentum_in_play = 0;                  // largest sum of m |v| of a record
    std::vector<std::string> files;
    bool ok() const { return !trouble && !interrupted; }
};

/// Runs to t_end, or until trouble. A step that carries no verdict of its own may throw OutsideGrid.
RunResult run(Simulation& simulation, const RunPlan& plan);

/// SIGINT and SIGTERM let the running step finish and end the run with exit code 130.
void catch_interrupts();
bool interrupted();

}  // namespace mpm
