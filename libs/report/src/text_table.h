// SPDX-License-Identifier: BSD-3-Clause
// Cells and paragraphs of text for a terminal.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "vdamf/files/numbers.h"

namespace vdamf
{
inline std::string leftCell(const std::string& text, std::size_t width)
{
    return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

inline std::string rightCell(const std::string& text, std::size_t width)
{
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// "-" for what is not known, or no number.
inline std::string numberCell(double value, int decimals)
{
    return std::isfinite(value) ? toFixedText(value, decimals) : "-";
}

inline std::string numberCell(const std::optional<double>& value, int decimals)
{
    return numberCell(value.value_or(kUnknown), decimals);
}

/// Breaks at blanks before the column `width`; lines after the first are indented.
inline std::string wrapped(const std::string& text, std::size_t indent, std::size_t width)
{
    std::string lines;
    std::size_t column = 0;
    std::size_t begin = 0;
    while (begin < text.size())
    {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        if (column > 0 && indent + column + 1 + word.size() > width)
        {
            lines += '\n' + std::string(indent, ' ');
            column = 0;
        }
        lines += (column > 0 ? " " : "") + word;
        column += (column > 0 ? 1 : 0) + word.size();
        begin = end + 1;
    }
    return lines;
}

}  // namespace vdamf
