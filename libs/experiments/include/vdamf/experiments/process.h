// SPDX-License-Identifier: BSD-3-Clause
// Runs other programs, without a shell.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vdamf
{
/// A program that runs beside this one. It is ended, and waited for, with its owner.
class ChildProcess
{
public:
    /// Starts a program (its path, or a name that is looked up in PATH, then its arguments) with
    /// nothing to read; what it prints is added to `log`. Throws std::runtime_error where it
    /// cannot be started.
    ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& log);
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;

    /// The exit code, or 128 + the signal that ended it; nothing as long as it runs.
    std::optional<int> poll();
    int wait();  ///< for its end; the same code

    void signal(int number) const;  ///< nothing happens once it has ended
    pid_t id() const { return id_; }

private:
    pid_t id_ = 0;
    std::optional<int> exitCode_;
};

/// Runs a program and waits for it; the command and what the program prints are added to `log`.
/// The exit code as ChildProcess gives it. May be called from several threads at once.
int runProgram(const std::vector<std::string>& command, const std::filesystem::path& log);

/// "ended with code 2", "was ended by signal 9 (Killed)".
std::string exitInWords(int exitCode);

/// The last line of a log that says something; empty if there is none.
std::string lastWords(const std::filesystem::path& log);

}  // namespace vdamf
