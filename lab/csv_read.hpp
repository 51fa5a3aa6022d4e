/// CSV files read back: a header row, then rows of text; fields may be quoted (lab/record.hpp writes them).
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mpm {

struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  // each as long as `columns`

    bool has(const std::string& column) const;
    /// The field of a row under a column's name; both throw std::out_of_range where there is none.
    const std::string& text(std::size_t row, const std::string& column) const;
    double number(std::size_t row, const std::string& column) const;  // nan for what is not a number
};

/// Reads CSV text. A last row without its line end is left out: its writer was stopped in the middle of it. Throws FileTrouble, with `name`
/// and the row, where a row has another length than the header.
CsvTable parse_csv(std::string_view text, const std::string& name);

/// Reads a CSV file. Throws FileTrouble.
CsvTable read_csv(const std::string& path);

/// A whole small file. Throws FileTrouble.
std::string read_file(const std::string& path);

}  // namespace mpm
