// SPDX-License-Identifier: BSD-3-Clause
// Text and numbers for pages.
#pragma once

#include <optional>
#include <string>

namespace vdamf
{
/// Safe between tags and in double quotes.
std::string escapedHtml(const std::string& text);

/// With 4 significant digits; a dash where it is not known.
std::string shownNumber(std::optional<double> value);

}  // namespace vdamf
