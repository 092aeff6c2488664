// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text, the same in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vdamf
{
/// The finite number that the text is from its first to its last character; nothing otherwise.
std::optional<double> parseNumber(std::string_view text);

/// The same for whole numbers: "3", "-3", not "3.0".
std::optional<std::int64_t> parseInteger(std::string_view text);

/// Shortest decimal text that reads back as exactly this number.
std::string toText(double value);

/// With a fixed number of decimals: toFixedText(1.0, 3) is "1.000". No negative zero.
std::string toFixedText(double value, int decimals);

/// Without blanks, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace vdamf
