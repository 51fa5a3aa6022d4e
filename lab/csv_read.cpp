#include "lab/csv_read.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm {

bool CsvTable::has(const std::string& column) const { return std::find(columns.begin(), columns.end(), column) != columns.end(); }

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
    const auto at = std::find(columns.begin(), columns.end(), column);
    if (at == columns.end()) throw std::out_of_range("no column " + column);
    return rows.at(row).at(static_cast<std::size_t>(at - columns.begin()));
}

double CsvTable::number(std::size_t row, const std::string& column) const {
    const std::string& field = text(row, column);
    char* end = nullptr;
    const double value = std::strtod(field.c_str(), &end);
    return end != field.c_str() && *end == '\0' ? value : std::numeric_limits<double>::quiet_NaN();
}

CsvTable parse_csv(std::string_view text, const std::string& name) {
    CsvTable table;
    std::vector<std::string> row;
    std::string field;
    bool quoted = false;
    const auto end_row = [&] {
        row.push_back(std::exchange(field, {}));
        if (table.columns.empty()) {
            table.columns = std::move(row);
        } else if (row.size() != table.columns.size()) {
            throw FileTrouble(name + ": row " + std::to_string(table.rows.size() + 1) + " has " + std::to_string(row.size()) +
                              " fields, the header " + std::to_string(table.columns.size()));
        } else {
            table.rows.push_back(std::move(row));
        }
        row.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const char next = i + 1 < text.size() ? text[i + 1] : '\0';
        if (c == '"' && quoted && next == '"')
            field += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (quoted)
            field += c;
        else if (c == ',')
            row.push_back(std::exchange(field, {}));
        else if (c == '\n')
            end_row();
        else if (c != '\r' || next != '\n')
            field += c;
    }
    return table;
}

CsvTable read_csv(const std::string& path) { return parse_csv(read_file(path), path); }

std::string read_file(const std::string& path) {
    const auto trouble = [&](const char* why) { return FileTrouble("cannot read '" + one_line(path, 300) + "': " + why); };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw trouble("it is a directory");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) throw trouble(std::strerror(errno));
    std::string text;
    char part[1 << 16];
    for (std::size_t n = 0; (n = std::fread(part, 1, sizeof part, file.get())) > 0;) text.append(part, n);
    if (std::ferror(file.get()) != 0) throw trouble(std::strerror(errno));
    return text;
}

}  // namespace mpm
