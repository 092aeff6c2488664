// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr int kSignalBase = 128;

// Input from nowhere, output and errors to the end of the log.
class Redirection
{
public:
    explicit Redirection(const std::filesystem::path& log)
    {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(),
                                           O_WRONLY | O_CREAT | O_APPEND, 0644);
        ::posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    }
    ~Redirection() { ::posix_spawn_file_actions_destroy(&actions_); }
    Redirection(const Redirection&) = delete;
    Redirection& operator=(const Redirection&) = delete;

    const posix_spawn_file_actions_t* actions() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_ = {};
};

void noteCommand(const std::vector<std::string>& command, const std::filesystem::path& log)
{
    std::ofstream file(log, std::ios::app);
    file << "$";
    for (const std::string& part : command) file << " " << part;
    file << "\n";
    if (!file.flush()) throw std::runtime_error("cannot write " + log.string());
}
}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::filesystem::path& log)
{
    std::vector<std::string> parts = command;
    std::vector<char*> arguments;
    for (std::string& part : parts) arguments.push_back(part.data());
    arguments.push_back(nullptr);
    const Redirection redirection(log);
    const int error = ::posix_spawnp(&id_, arguments.front(), redirection.actions(), nullptr,
                                     arguments.data(), environ);
    if (error != 0)
        throw std::runtime_error("cannot start " + command.front() + ": " +
                                 std::system_category().message(error));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : id_(std::exchange(other.id_, 0)), exitCode_(other.exitCode_)
{
}

ChildProcess::~ChildProcess()
{
    if (id_ == 0 || exitCode_) return;
    signal(SIGKILL);
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR)
    {
    }
}

std::optional<int> ChildProcess::poll()
{
    if (exitCode_) return exitCode_;
    int status = 0;
    const pid_t ended = ::waitpid(id_, &status, WNOHANG);
    if (ended < 0 && errno != EINTR)
        throw std::system_error(errno, std::system_category(), "waitpid");
    if (ended == id_)
        exitCode_ = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
    return exitCode_;
}

int ChildProcess::wait()
{
    siginfo_t info = {};
    while (!poll())
    {
        if (::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOWAIT) < 0 && errno != EINTR)
            throw std::system_error(errno, std::system_category(), "waitid");
    }
    return *exitCode_;
}

void ChildProcess::signal(int number) const
{
    if (id_ != 0 && !exitCode_) ::kill(id_, number);
}

int runProgram(const std::vector<std::string>& command, const std::filesystem::path& log)
{
    noteCommand(command, log);
    return ChildProcess(command, log).wait();
}

std::string exitInWords(int exitCode)
{
    if (exitCode <= kSignalBase) return "ended with code " + std::to_string(exitCode);
    const int number = exitCode - kSignalBase;
    return "was ended by signal " + std::to_string(number) + " (" + ::strsignal(number) + ")";
}

std::string lastWords(const std::filesystem::path& log)
{
    const std::string text = readTextFile(log);
    const std::size_t end = text.find_last_not_of(" \t\r\n");
    if (end == std::string::npos) return "";
    const std::size_t before = text.find_last_of('\n', end);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return std::string(trimmed(std::string_view(text).substr(begin, end + 1 - begin)));
}

}  // namespace vdamf
