// SPDX-License-Identifier: BSD-3-Clause
// Cells to a line.
#pragma once

#include <string>
#include <vector>

namespace vdamf
{
inline std::string joined(const std::vector<std::string>& cells, const char* separator)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : separator) + cells[i];
    return line;
}

}  // namespace vdamf
