// SPDX-License-Identifier: BSD-3-Clause
// Lists in values of ini files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vdamf
{
/// The parts between separators, without blanks at their ends; one empty part of an empty text.
std::vector<std::string> split(std::string_view text, char separator);

}  // namespace vdamf
