// SPDX-License-Identifier: BSD-3-Clause
#include "html.h"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "vdamf/files/numbers.h"

namespace vdamf
{
std::string escapedHtml(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        switch (c)
        {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string shownNumber(std::optional<double> value)
{
    if (!value) return "\u2013";
    std::array<char, 40> text = {};
    std::snprintf(text.data(), text.size(), "%.4g", *value);
    return toText(std::strtod(text.data(), nullptr));
}

}  // namespace vdamf
