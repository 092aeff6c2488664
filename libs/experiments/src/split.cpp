// SPDX-License-Identifier: BSD-3-Clause
#include "split.h"

#include <algorithm>

#include "vdamf/files/numbers.h"

namespace vdamf
{
std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();)
    {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.emplace_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

}  // namespace vdamf
