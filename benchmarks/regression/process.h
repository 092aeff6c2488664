// SPDX-License-Identifier: BSD-3-Clause
// Runs another program and waits for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vdamf
{
/// Runs a program (its path, then its arguments) without a shell; the command and what the program
/// prints are added to `log`. The exit code, or 128 + the signal that ended it. Throws
/// std::runtime_error where it cannot be started. May be called from several threads at once.
int runProgram(const std::vector<std::string>& command, const std::filesystem::path& log);

}  // namespace vdamf
