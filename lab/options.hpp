/// Command line and config file of every program: each option has a default, a unit, a range and a line of help.
#pragma once
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace mpm {

/// Bad input: one line that names the option, the value and what is allowed. Programs end with exit code 2.
struct BadInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};
/// Could not read or write something: says what and where. Programs end with exit code 1.
struct FileTrouble : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Allowed interval of a number, e.g. above(0), between(0, 1); printed as it stands in messages and help.
struct Range {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    bool low_open = false, high_open = false;
    bool contains(double x) const;  // false for nan; infinite values are never allowed
    std::string text() const;       // "> 0", "0 ... 1", "any number"
};
Range any();
Range above(double low);      // > low
Range at_least(double low);   // >= low
Range between(double low, double high);

/// The options of one program. Each call binds a variable, which holds the default until `parse` writes to it.
/// Names are given without dashes; units as text, "-" for none.
class Options {
public:
    Options(std::string program, std::string purpose);
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    void number(const std::string& name, double& value, const std::string& unit, Range range, const std::string& help);
    void integer(const std::string& name, int& value, const std::string& unit, Range range, const std::string& help);
    void integers(const std::string& name, std::vector<int>& value, const std::string& unit, Range range, const std::string& help);
    void choice(const std::string& name, std::string& value, const std::vector<std::string>& allowed, const std::string& help);
    void text(const std::string& name, std::string& value, const std::string& help);
    void flag(const std::string& name, bool& value, const std::string& help);
    /// Two options that cannot be given together; b is in use unless a is given. A command line's a puts a config file's b out of use.
    void contradict(const std::string& a, const std::string& b);
    /// Leaves an option out of `label` and `changed` (where files go, how much is printed).
    void unlabelled(const std::string& name);

    /// Reads `--config FILE` first, then the command line, which wins. Throws BadInput (or FileTrouble if the config cannot be read) and
    /// then leaves every bound variable as it was. `--help`, `--version`, `--describe` are handled by the caller through `asked`.
    void parse(int argc, const char* const* argv);
    bool asked(const std::string& name) const;  // whether help, version, describe was given
    bool given(const std::string& name) const;  // whether it differs from being absent (command line or config)

    std::string label() const;     // the options that differ from their defaults: "mode-10_cfl-0.2", or "default"
    std::string changed() const;   // the same as "mode=10;cfl=0.2"
    std::string help() const;      // one line per option: default, unit, range
    std::string describe() const;  // CSV for programs: name,type,default,unit,low,high,choices,help
    std::string ini() const;       // every option as `name = value`, in the form `--config` reads

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The known word nearest to an unknown one by edit distance, or "" if none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace mpm
