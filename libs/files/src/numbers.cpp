// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace vdamf
{
namespace
{
// std::from_chars takes no plus sign; people write one.
std::string_view withoutPlus(std::string_view text)
{
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+')
        text.remove_prefix(1);
    return text;
}

template <class Number>
std::optional<Number> parseWhole(std::string_view text)
{
    text = withoutPlus(text);
    Number value = {};
    const char* const end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
    return value;
}
}  // namespace

std::optional<double> parseNumber(std::string_view text)
{
    const std::optional<double> value = parseWhole<double>(text);
    if (value && !std::isfinite(*value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> parseInteger(std::string_view text)
{
    return parseWhole<std::int64_t>(text);
}

std::string toText(double value)
{
    std::array<char, 64> buffer = {};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), result.ptr);
}

std::string toFixedText(double value, int decimals)
{
    // Fixed notation of the largest double has 309 digits before the point.
    std::array<char, 400> buffer = {};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                      std::chars_format::fixed, decimals);
    std::string text(buffer.data(), result.ptr);
    if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
    return text;
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n\f\v";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace vdamf
