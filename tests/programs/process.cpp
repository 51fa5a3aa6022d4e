#include "tests/programs/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace mpm::test {

namespace fs = std::filesystem;

namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void redirect(int target, const std::string& path, int flags) {
    const int file = open(path.c_str(), flags, 0644);
    if (file < 0 || dup2(file, target) < 0) _exit(126);
    close(file);
}

}  // namespace

Words programs() {
    std::istringstream names(MPM_PROGRAMS);
    Words all;
    for (std::string name; std::getline(names, name, ',');) all.push_back(name);
    return all;
}

Folder::Folder() {
    std::string pattern = testing::TempDir() + "mpm_programs_XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + pattern);
    path_ = pattern + "/work";
    output_ = pattern;  // what programs print is kept beside their folder, not in it
    fs::create_directory(path_);
}
Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(output_, ignored);
}

std::string Folder::read(const std::string& name) const { return text_of(path(name)); }

std::map<std::string, std::pair<fs::file_time_type, std::string>> Folder::listing(const std::string& name) const {
    std::map<std::string, std::pair<fs::file_time_type, std::string>> all;
    for (const auto& entry : fs::recursive_directory_iterator(path(name)))
        all[entry.path().string()] = {entry.last_write_time(), entry.is_regular_file() ? text_of(entry.path()) : ""};
    return all;
}

pid_t Folder::start(const std::string& program, const Words& words) const {
    const std::string binary = std::string(MPM_BUILD_DIR) + "/" + program;
    std::vector<char*> argv{const_cast<char*>(binary.c_str())};  // execv takes what it does not change as char*
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const pid_t process = fork();
    if (process != 0) return process;
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, output_ + "/stdout", O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, output_ + "/stderr", O_WRONLY | O_CREAT | O_TRUNC);
    if (chdir(path_.c_str()) == 0) execv(binary.c_str(), argv.data());
    _exit(127);
}

Ending Folder::finish(pid_t process) const {
    int status = 0;
    if (waitpid(process, &status, 0) != process) throw std::runtime_error("no such process");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(output_ + "/stdout"), text_of(output_ + "/stderr")};
}

Ending Folder::run(const std::string& program, const Words& words) const { return finish(start(program, words)); }

std::vector<Words> csv(const std::string& text) {
    std::vector<Words> rows;
    Words row{""};
    bool quoted = false;
    for (const char c : text) {
        if (c == '"')
            quoted = !quoted;  // a doubled quote inside changes twice; its text is not looked at here
        else if (c == ',' && !quoted)
            row.emplace_back();
        else if (c == '\n' && !quoted)
            rows.push_back(row), row = {""};
        else
            row.back() += c;
    }
    if (row != Words{""}) rows.push_back(row);
    return rows;
}

std::string field(const std::vector<Words>& table, std::size_t row, const std::string& column) {
    const Words& header = table.at(0);
    const auto at = std::find(header.begin(), header.end(), column);
    if (at == header.end()) throw std::runtime_error("no column " + column);
    return table.at(row).at(static_cast<std::size_t>(at - header.begin()));
}

void expect_readable(const std::string& text, const std::string& name) {
    ASSERT_FALSE(text.empty()) << name;
    EXPECT_EQ(text.back(), '\n') << name << " ends within a row";
    const auto rows = csv(text);
    for (std::size_t i = 1; i < rows.size(); ++i) ASSERT_EQ(rows[i].size(), rows[0].size()) << name << ", row " << i;
}

int expect_readable_files(const Folder& folder, const std::string& name) {
    int files = 0;
    for (const auto& [path, content] : folder.listing(name)) {
        if (!path.ends_with(".csv")) continue;
        expect_readable(content.second, path);
        ++files;
    }
    return files;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void expect_one_line(const Ending& ending, int code, const Words& parts) {
    EXPECT_EQ(ending.code, code) << ending.err;
    EXPECT_EQ(ending.out, "");
    EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
    EXPECT_TRUE(ending.err.ends_with('\n')) << ending.err;
    for (const std::string& part : parts) EXPECT_TRUE(holds(ending.err, part)) << "'" << part << "' is missing in: " << ending.err;
}

}  // namespace mpm::test
