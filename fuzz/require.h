// SPDX-License-Identifier: BSD-3-Clause
// How a target says that what it fuzzes is wrong, in any build.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>

namespace vdamf::fuzz
{
/// Ends the program where the condition does not hold: for libFuzzer that is a finding.
inline void require(bool condition, const char* what)
{
    if (condition) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

/// Runs what may refuse its input. Inputs are refused by std::runtime_error alone: everything else
/// that is thrown is a finding.
template <class Call>
void mayRefuse(Call&& call)
{
    try
    {
        call();
    }
    catch (const std::runtime_error& error)
    {
        require(*error.what() != '\0', "an error has a message");
    }
}

}  // namespace vdamf::fuzz
