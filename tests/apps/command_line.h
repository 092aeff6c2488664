// SPDX-License-Identifier: BSD-3-Clause
// Runs the project's programs as a user would.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace vdamf
{
struct Outcome
{
    int exitCode = -1;
    std::string output;  ///< of both streams
};

/// Runs a shell command.
inline Outcome runShell(const std::string& command)
{
    Outcome run;
    std::FILE* pipe = ::popen(("( " + command + " ) 2>&1").c_str(), "r");
    if (pipe == nullptr) return run;
    std::array<char, 4096> buffer = {};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        run.output.append(buffer.data(), count);
    const int status = ::pclose(pipe);
    if (WIFEXITED(status)) run.exitCode = WEXITSTATUS(status);
    return run;
}

/// Runs a program of the build with arguments, for example runApp("vdamf-track", "--help").
inline Outcome runApp(const std::string& name, const std::string& arguments)
{
    return runShell("'" VDAMF_APPS_DIR "/" + name + "' " + arguments);
}

}  // namespace vdamf
