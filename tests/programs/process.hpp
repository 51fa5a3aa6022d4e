/// Runs the built programs as a user would, and looks at what they print and write.
#pragma once
#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mpm::test {

using Words = std::vector<std::string>;

/// The programs under test: every bar that CMakeLists.txt adds.
Words programs();
inline std::string program_name(const testing::TestParamInfo<std::string>& program) { return program.param; }

/// How a program ended: its exit code (128 + signal if one killed it) and all that it printed.
struct Ending {
    int code = 0;
    std::string out, err;
};

/// A fresh folder in which programs run; it goes away with the test.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string path(const std::string& name = "") const { return name.empty() ? path_ : path_ + "/" + name; }
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
    bool empty() const { return std::filesystem::is_empty(path_); }

    /// Every file and folder inside: its time of change and its text.
    std::map<std::string, std::pair<std::filesystem::file_time_type, std::string>> listing(const std::string& name = "") const;

    Ending run(const std::string& program, const Words& words) const;
    /// Starts a program without waiting; `finish` waits for it.
    pid_t start(const std::string& program, const Words& words) const;
    Ending finish(pid_t process) const;

private:
    std::string path_, output_;
};

/// A CSV file as rows of fields. The first row is the header.
std::vector<Words> csv(const std::string& text);
/// The field of a row under a column's name.
std::string field(const std::vector<Words>& table, std::size_t row, const std::string& column);
/// Every row whole and of the header's length.
void expect_readable(const std::string& text, const std::string& name);
/// All CSV files of a folder and those below it are readable; returns how many there are.
int expect_readable_files(const Folder& folder, const std::string& name);

bool holds(const std::string& text, const std::string& part);
/// One line on stderr that holds each part, nothing on stdout.
void expect_one_line(const Ending& ending, int code, const Words& parts);

}  // namespace mpm::test
