/// What implicit runs say of their Newton iterations: newton.csv and lines of the report.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chapters/implicit/implicit.hpp"
#include "lab/record.hpp"

namespace mpm {

/// newton.csv: a row for each iteration of each solution. Without a path it writes nothing.
class NewtonFile {
public:
    explicit NewtonFile(const std::string& path) : path_(path) {}
    /// Writes what has been added to the history since the last call.
    void write(const std::vector<SolvedStep>& history);

private:
    std::string path_;
    std::unique_ptr<CsvFile> file_;
    std::size_t written_ = 0;
};

void add_facts(const ImplicitCounts& counts, std::vector<std::pair<std::string, double>>& facts);

}  // namespace mpm
