// SPDX-License-Identifier: BSD-3-Clause
// Learned filters as text: docs/filters.md.
#pragma once

#include <string>
#include <string_view>

#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
/// Strict ini text that parseFilterBank() reads back to the same filters.
std::string toText(const FilterBank& bank);

/// Throws std::runtime_error with `name`, line and key for a text of another version, one that ends
/// early, keys and sections that are missing, doubled or unknown, and values that are no finite
/// numbers in their ranges.
FilterBank parseFilterBank(std::string_view text, const std::string& name);

/// The options with the filters that they name; unchanged where they name no file. Throws
/// std::runtime_error where the file cannot be read or holds no filters.
MeasureOptions withFilterFromFile(const MeasureOptions& options);

}  // namespace vdamf
