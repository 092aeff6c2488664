// SPDX-License-Identifier: BSD-3-Clause
// "Did you mean": the known name that is nearest to a misspelt one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vdamf
{
/// Least number of inserted, deleted, replaced or swapped neighbouring characters.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate with the least edit distance; empty where all are too far to be a misspelling.
std::string nearestName(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace vdamf
