#include "lab/record.hpp"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "lab/options.hpp"

namespace mpm {

namespace {

[[noreturn]] void trouble(const std::string& what, const std::string& path, int error) {
    throw FileTrouble("cannot " + what + " '" + one_line(path, 300) + "': " + std::strerror(error));
}

/// Writes and flushes all of `text`; the error number, or 0.
int put(std::FILE* file, const std::string& text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0) return 0;
    return errno != 0 ? errno : EIO;
}

std::string joined(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) line += ',';
        line += csv_field(fields[i]);
    }
    return line + '\n';
}

}  // namespace

std::string number_text(double x) {
    if (std::isnan(x)) return "nan";  // to_chars would tell -nan from nan
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, x).ptr;
    return {text, end};
}

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string one_line(std::string_view text, std::size_t limit) {
    std::string line;
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool continues = (c & 0xC0u) == 0x80u;  // a later byte of a UTF-8 character
        if (!continues && ++count > limit) return line + "...";
        if (c == '\n') line += "\\n";
        else if (c == '\t') line += "\\t";
        else if (c == '\r') line += "\\r";
        else if (c < 0x20 || c == 0x7F || (continues && (line.empty() || static_cast<unsigned char>(line.back()) < 0x80u))) {
            char code[8];
            std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(c));
            if (continues && ++count > limit) return line + "...";
            line += code;
        } else line += text[i];
    }
    return line;
}

CsvFile::CsvFile(const std::string& path, const std::vector<std::string>& columns)
    : path_(path), file_(std::fopen(path.c_str(), "wb")), columns_(columns.size()) {
    if (file_ == nullptr) trouble("open", path_, errno);
    if (const int error = put(file_, joined(columns)); error != 0) {
        std::fclose(file_);
        trouble("write", path_, error);
    }
}

CsvFile::~CsvFile() { std::fclose(file_); }  // every row is flushed already

void CsvFile::row(const double* values, std::size_t n) {
    if (n != columns_) throw std::logic_error("a row of " + path_ + " has the wrong number of values");
    std::string line;
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0) line += ',';
        line += number_text(values[i]);
    }
    write(line + '\n');
}

void CsvFile::row(const std::vector<std::string>& fields) {
    if (fields.size() != columns_) throw std::logic_error("a row of " + path_ + " has the wrong number of fields");
    write(joined(fields));
}

void CsvFile::write(const std::string& line) {
    if (const int error = put(file_, line); error != 0) trouble("write", path_, error);
}

void replace_file(const std::string& path, const std::function<int(const std::string& part)>& write) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw FileTrouble("cannot write '" + one_line(path, 300) + "': not a regular file");
    const std::string part = path + ".part" + std::to_string(getpid());
    int error = write(part);
    if (error == 0 && std::rename(part.c_str(), path.c_str()) != 0) error = errno;
    if (error == 0) return;
    std::remove(part.c_str());
    trouble("write", path, error);
}

void write_file(const std::string& path, const std::string& text) {
    replace_file(path, [&](const std::string& part) {
        std::FILE* file = std::fopen(part.c_str(), "wb");
        if (file == nullptr) return errno;
        const int error = put(file, text);
        return std::fclose(file) != 0 && error == 0 ? errno : error;
    });
}

}  // namespace mpm
