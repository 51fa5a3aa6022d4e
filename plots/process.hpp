/// Programs run as processes of their own, with what the operating system measured of each.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mpm {

struct Command {
    std::string program;             // path
    std::vector<std::string> words;  // its arguments
};
/// The command as a shell reads it.
std::string shell_text(const Command& command);

/// How a process ended, and what it took from start to end.
struct Ending {
    int code = 0, signal = 0;  // exit code; the signal that killed it, or 0
    bool timed_out = false, stopped = false;
    double wall_s = 0, cpu_s = 0;
    long peak_rss_kb = 0;  // at least what its parent had allocated when it started, so parents should stay small
    bool usable() const { return signal == 0 && !timed_out && (code == 0 || code == 3); }  // 3: unstable, which is a result
    std::string trouble() const;  // "" if usable, else "failed:exit 1", "failed:signal 9", "failed:timeout"
};
/// What `trouble` says of a code as a shell reports it, 128 + signal for a killed process.
std::string shell_trouble(int code);

/// One running program. It reads nothing, and writes to two files (or /dev/null).
class Process {
public:
    Process(const Command& command, const std::string& output, const std::string& errors, double timeout);
    ~Process();  // ends it if it still runs
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Looks without waiting: its ending once it has ended. One that is over its time (0: none) is killed.
    std::optional<Ending> look();
    /// Asks it to end, waits a little, and kills it if it does not.
    Ending stop();

private:
    Ending ending(int status, double cpu, long peak) const;
    double age() const;
    pid_t pid_;
    std::chrono::steady_clock::time_point start_;
    double timeout_;
    bool timed_out_ = false;
};

/// Runs a program to its end. When lab/run.hpp's interrupted() turns true, or `timeout` seconds (0: none) have passed, it is ended first;
/// then `stopped` or `timed_out` says so. `waiting` is called several times a second.
Ending run_process(const Command& command, const std::string& output, const std::string& errors, double timeout,
                   const std::function<void()>& waiting = {});

/// Sleeps between two looks at a process: briefly at first, so that short runs are not slowed down. Ends early on a signal.
class Nap {
public:
    void sleep();
    void reset() { microseconds_ = shortest; }

private:
    static constexpr long shortest = 500, longest = 50000;
    long microseconds_ = shortest;
};

}  // namespace mpm
