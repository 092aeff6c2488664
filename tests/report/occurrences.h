// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace vdamf
{
/// How often a part stands in a text.
inline std::size_t countOf(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

}  // namespace vdamf
