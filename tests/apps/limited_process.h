// SPDX-License-Identifier: BSD-3-Clause
// Runs a program and tells how it ended and what it took.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace vdamf
{
// What the sanitizers take beside the program.
#ifdef __SANITIZE_ADDRESS__
inline constexpr double kMoreTime = 8.0;
inline constexpr double kMoreMemory = 3.0;
#else
inline constexpr double kMoreTime = 1.0;
inline constexpr double kMoreMemory = 1.0;
#endif

struct ProcessOptions
{
    double longest = 120.0 * kMoreTime;  ///< s; then it is killed
    std::optional<rlim_t> largestFile;   ///< bytes (RLIMIT_FSIZE)
    std::string input = "/dev/null";     ///< standard input
    std::string output = "/dev/null";    ///< standard output
    std::string errors = "/dev/null";    ///< standard error
};

struct ProcessEnd
{
    int exitCode = -1;       ///< -1: killed
    int signal = 0;          ///< that ended it; 0: none
    bool late = false;       ///< killed because it took too long
    double seconds = 0.0;    ///< of computing: others may keep the machine busy
    double megabytes = 0.0;  ///< largest resident memory
};

/// A program of the build that runs beside the test.
class LimitedProcess
{
public:
    LimitedProcess(const std::string& app, std::vector<std::string> arguments,
                   ProcessOptions options = {})
        : options_(std::move(options)), begin_(Clock::now())
    {
        arguments.insert(arguments.begin(), VDAMF_APPS_DIR "/" + app);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        child_ = ::fork();
        if (child_ == 0) start(argv);
    }
    ~LimitedProcess()
    {
        if (child_ <= 0) return;
        send(SIGKILL);
        ::waitpid(child_, nullptr, 0);
    }
    LimitedProcess(const LimitedProcess&) = delete;
    LimitedProcess& operator=(const LimitedProcess&) = delete;

    void send(int signal) const { ::kill(child_, signal); }

    bool hasEnded()
    {
        int status = 0;
        rusage usage = {};
        if (child_ <= 0) return true;
        if (::wait4(child_, &status, WNOHANG, &usage) != child_) return false;
        child_ = -1;
        end_.seconds = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
        end_.megabytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
        if (WIFEXITED(status)) end_.exitCode = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) end_.signal = WTERMSIG(status);
        return true;
    }

    ProcessEnd wait()
    {
        while (!hasEnded())
        {
            if (elapsed() > options_.longest && !end_.late)
            {
                end_.late = true;
                send(SIGKILL);
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return end_;
    }

private:
    using Clock = std::chrono::steady_clock;

    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

    static double secondsOf(const timeval& time)
    {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }

    [[noreturn]] void start(const std::vector<char*>& argv) const
    {
        if (options_.largestFile)
        {
            const rlimit limit = {*options_.largestFile, *options_.largestFile};
            ::setrlimit(RLIMIT_FSIZE, &limit);
        }
        redirect(options_.input, O_RDONLY, STDIN_FILENO);
        redirect(options_.output, O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
        redirect(options_.errors, O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }

    static void redirect(const std::string& path, int flags, int to)
    {
        const int from = ::open(path.c_str(), flags, 0666);
        ::dup2(from, to);
        ::close(from);
    }

    ProcessOptions options_;
    Clock::time_point begin_;
    pid_t child_ = -1;
    ProcessEnd end_;
};

inline ProcessEnd runLimited(const std::string& app, std::vector<std::string> arguments,
                             ProcessOptions options = {})
{
    return LimitedProcess(app, std::move(arguments), std::move(options)).wait();
}

}  // namespace vdamf
