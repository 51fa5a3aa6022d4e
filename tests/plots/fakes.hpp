/// Tiny programs that behave as the real ones do towards compare and stability, or badly.
#pragma once
#include "tests/programs/process.hpp"

namespace mpm::test {

/// A folder with fake programs in bin/, each named after what it does:
///   good, better        error 1/cells^2 and 1/cells^3, and half as much under another name
///   limited             unstable when --dt is over 0.7 of its critical step, which is 0.01
///   unstable            unstable from 100 cells on
///   fails, crashes, killed, hangs, silent    exit 1, signal 11, signal 9, no end, no summary
///   half, strange       a summary cut within its first row, one with other columns
///   strict              refuses --mode 7 by --dry-run
///   gridless            has no option --cells
class Fakes : public Folder {
public:
    Fakes();
    /// `compare` or `stability` with these programs, no pictures, and `words`.
    Ending tool(const std::string& name, const Words& words) const { return run(name, told(words)); }
    Words told(const Words& words) const;
    /// How many runs the fakes have been asked for.
    int runs() const;
};

}  // namespace mpm::test
