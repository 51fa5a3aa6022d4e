/// The progress bar of a long run, on a terminal.
#pragma once

namespace mpm {

/// Draws nothing in the first second, nor when not `active`; wipes itself when it goes.
class Progress {
public:
    explicit Progress(bool active);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void at(double fraction);  // 0 ... 1

private:
    bool active_, drawn_ = false;
    double start_, last_;  // seconds
};

}  // namespace mpm
