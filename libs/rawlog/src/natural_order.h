// SPDX-License-Identifier: BSD-3-Clause
// The order that people give names with numbers in them.
#pragma once

#include <algorithm>
#include <string_view>

namespace vdamf
{
/// True where `a` comes before `b`: runs of digits count as numbers, "scan_9" before "scan_10".
inline bool naturallyBefore(std::string_view a, std::string_view b)
{
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const auto number = [&](std::string_view& text)
    {
        const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
        std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
        text.remove_prefix(digits.size());
        digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
        return digits;
    };
    const std::string_view wholeA = a;
    const std::string_view wholeB = b;
    while (!a.empty() && !b.empty())
    {
        if (isDigit(a.front()) && isDigit(b.front()))
        {
            const std::string_view x = number(a);
            const std::string_view y = number(b);
            if (x.size() != y.size()) return x.size() < y.size();
            if (x != y) return x < y;
            continue;
        }
        if (a.front() != b.front()) return a.front() < b.front();
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    if (a.empty() != b.empty()) return a.empty();
    return wholeA < wholeB;
}

}  // namespace vdamf
