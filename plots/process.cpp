#include "plots/process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

#include "lab/options.hpp"
#include "lab/run.hpp"

namespace mpm {
namespace {

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

void redirect(int target, const char* path, int flags) {
    const int file = open(path, flags, 0644);
    if (file < 0 || dup2(file, target) < 0) _exit(126);
    close(file);
}

}  // namespace

std::string shell_text(const Command& command) {
    std::string text;
    std::vector<std::string> words{command.program};
    words.insert(words.end(), command.words.begin(), command.words.end());
    for (const std::string& word : words) {
        const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
            return std::isalnum(c) != 0 || std::strchr("_-+=:,./%@", c) != nullptr;
        });
        if (!text.empty()) text += ' ';
        if (plain) {
            text += word;
            continue;
        }
        text += '\'';
        for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
        text += '\'';
    }
    return text;
}

std::string Ending::trouble() const {
    if (usable()) return "";
    if (timed_out) return "failed:timeout";
    return signal != 0 ? "failed:signal " + std::to_string(signal) : "failed:exit " + std::to_string(code);
}

std::string shell_trouble(int code) {
    Ending ending;
    (code > 128 ? ending.signal : ending.code) = code > 128 ? code - 128 : code;
    return ending.trouble();
}

Process::Process(const Command& command, const std::string& output, const std::string& errors, double timeout)
    : start_(std::chrono::steady_clock::now()), timeout_(timeout) {
    // Everything that allocates comes before the fork.
    std::vector<char*> argv{const_cast<char*>(command.program.c_str())};  // execv takes what it does not change as char*
    for (const std::string& word : command.words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ < 0) throw FileTrouble("cannot start " + command.program + ": " + std::strerror(errno));
    if (pid_ > 0) return;
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // a run does not outlive the sweep that waits for it, however that ends
    if (getppid() != parent) _exit(126);
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    execv(argv[0], argv.data());
    dprintf(STDERR_FILENO, "cannot run %s: %s\n", argv[0], std::strerror(errno));
    _exit(127);
}

Process::~Process() {
    if (pid_ > 0) stop();
}

double Process::age() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

Ending Process::ending(int status, double cpu, long peak) const {
    Ending e;
    if (WIFSIGNALED(status))
        e.signal = WTERMSIG(status);
    else
        e.code = WEXITSTATUS(status);
    e.timed_out = timed_out_;
    e.wall_s = age();
    e.cpu_s = cpu;
    e.peak_rss_kb = peak;
    return e;
}

std::optional<Ending> Process::look() {
    if (timeout_ > 0 && !timed_out_ && age() > timeout_) {
        timed_out_ = true;
        kill(pid_, SIGKILL);
    }
    int status = 0;
    rusage used{};
    const pid_t found = wait4(pid_, &status, WNOHANG, &used);
    if (found == 0 || (found < 0 && errno == EINTR)) return {};
    pid_ = 0;
    return ending(status, seconds(used.ru_utime) + seconds(used.ru_stime), used.ru_maxrss);
}

Ending Process::stop() {
    constexpr double patience = 3;  // seconds
    const double asked = age();
    kill(pid_, SIGTERM);
    for (Nap nap;; nap.sleep()) {
        if (age() > asked + patience) kill(pid_, SIGKILL);
        if (auto end = look()) {
            end->stopped = true;
            return *end;
        }
    }
}

Ending run_process(const Command& command, const std::string& output, const std::string& errors, double timeout,
                   const std::function<void()>& waiting) {
    Process process(command, output, errors, timeout);
    for (Nap nap;; nap.sleep()) {
        if (const auto end = process.look()) return *end;
        if (interrupted()) return process.stop();
        if (waiting) waiting();
    }
}

void Nap::sleep() {
    const timespec time{0, 1000 * microseconds_};
    nanosleep(&time, nullptr);
    microseconds_ = std::min(longest, 2 * microseconds_);
}

}  // namespace mpm
