/// CSV files: header row, commas, shortest decimals that read back exactly; rows are written whole and flushed.
#pragma once
#include <array>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace mpm {

/// Shortest decimal text that reads back to the same double; "nan", "inf".
std::string number_text(double x);
/// A CSV field: quoted when it holds a comma, a quote or a line break.
std::string csv_field(std::string_view text);

/// Foreign text for a one-line message: line breaks and control characters escaped, cut after `limit` characters (then "...").
std::string one_line(std::string_view text, std::size_t limit = 60);

/// A CSV file being written. Throws FileTrouble (lab/options.hpp) with the path when it cannot be opened or written (a full disk).
class CsvFile {
public:
    CsvFile(const std::string& path, const std::vector<std::string>& columns);
    ~CsvFile();
    CsvFile(const CsvFile&) = delete;
    CsvFile& operator=(const CsvFile&) = delete;
    void row(const double* values, std::size_t n);        // n must be the number of columns
    void row(const std::vector<std::string>& fields);     // already text; quoted where needed
    const std::string& path() const { return path_; }

private:
    void write(const std::string& line);
    std::string path_;
    std::FILE* file_;
    std::size_t columns_;
};

/// A CSV file whose number of columns is checked against each row's values at compile time.
template <std::size_t N> class Csv {
public:
    Csv(const std::string& path, const std::array<std::string, N>& columns) : file_(path, {columns.begin(), columns.end()}) {}
    template <class... Values> void row(Values... values) {
        static_assert(sizeof...(Values) == N, "a row needs one value for each column");
        const std::array<double, N> line{static_cast<double>(values)...};
        file_.row(line.data(), N);
    }
    void row(const std::array<double, N>& line) { file_.row(line.data(), N); }

private:
    CsvFile file_;
};

/// Replaces a file as a whole: `write` fills a temporary name beside it, which is then renamed, so that a reader never sees half of it. `write`
/// returns 0 or an error number. Throws FileTrouble.
void replace_file(const std::string& path, const std::function<int(const std::string& part)>& write);

/// Writes a whole small text file by replace_file. Throws FileTrouble.
void write_file(const std::string& path, const std::string& text);

}  // namespace mpm
