// SPDX-License-Identifier: BSD-3-Clause
// How every program begins and ends: command line, exit codes, signals, last words.
#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>

namespace vdamf
{
constexpr int kDone = 0;
constexpr int kFailed = 1;  ///< the work failed, was interrupted, or its input ended early
constexpr int kBadUse = 2;  ///< command line or configuration: nothing was done

struct Program
{
    std::string name;                        ///< as it is called, before each of its messages
    std::string purpose;                     ///< in --help, before the options
    std::string footer;                      ///< in --help, behind the options
    std::function<void(CLI::App&)> declare;  ///< adds the options
    std::function<void()> prepare;           ///< checks what was asked for; throws: bad use
    std::function<int()> work;               ///< the exit code; throws: failed
};

/// Parses, prepares and works; the exit code. What is thrown becomes a line on the standard error
/// that begins with the program's name; so does what was printed on the standard output and cannot
/// be written, which is a failure. A bare Program has `--help` and `--version`. An option
/// whose value is empty is bad use. Options that are integers take decimal numbers alone.
int runProgram(int argc, const char* const* argv, const Program& program);

/// What an exception says; "out of memory" where that is why.
std::string reasonOf(const std::exception& error);

/// From now on SIGINT, SIGTERM and, unless it is ignored, SIGHUP set the flag that is returned, and
/// interrupt what waits for a pipe.
const std::atomic<bool>& catchSignals();
bool isInterrupted();

/// A number in [min, max]; CLI::Range lets nan pass.
CLI::Validator within(double min, double max);

/// Throws std::runtime_error where what was printed cannot be written: a full disk or a closed
/// pipe shows itself at the latest here.
void checkPrinted(std::FILE* stream);

/// Whether the standard error is looked at.
bool isTerminal();

}  // namespace vdamf
