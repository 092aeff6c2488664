// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text, for pictures.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace vdamf
{
/// As std::printf() would print them, up to 255 characters.
inline std::string formatted(const char* pattern, double a, double b = 0.0, double c = 0.0,
                             double d = 0.0)
{
    std::array<char, 256> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, a, b, c, d);
    return buffer.data();
}

}  // namespace vdamf
