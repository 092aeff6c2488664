// SPDX-License-Identifier: BSD-3-Clause
#include "regression/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace vdamf
{
namespace
{
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

int waitFor(pid_t process)
{
    int status = 0;
    while (::waitpid(process, &status, 0) < 0)
        if (errno != EINTR) throw std::system_error(errno, std::system_category(), "waitpid");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
}  // namespace

int runProgram(const std::vector<std::string>& command, const std::filesystem::path& log)
{
    noteCommand(command, log);
    std::vector<std::string> parts = command;
    std::vector<char*> arguments;
    for (std::string& part : parts) arguments.push_back(part.data());
    arguments.push_back(nullptr);
    const Redirection redirection(log);
    pid_t process = 0;
    const int error = ::posix_spawn(&process, arguments.front(), redirection.actions(), nullptr,
                                    arguments.data(), environ);
    if (error != 0)
        throw std::runtime_error("cannot start " + command.front() + ": " +
                                 std::system_category().message(error));
    return waitFor(process);
}

}  // namespace vdamf
