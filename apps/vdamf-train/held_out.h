// SPDX-License-Identifier: BSD-3-Clause
// Errors on held-out clusters as text.
#pragma once

#include <string>
#include <vector>

#include "vdamf/learning/train_filter.h"

namespace vdamf
{
/// A line a condition and filter, medians and 90th percentiles.
std::string heldOutText(const std::vector<HeldOutCondition>& conditions);

/// The same as a table; `how` they were held out stands in each line.
std::string heldOutHeader();
std::string heldOutRows(const std::string& how, const std::vector<HeldOutCondition>& conditions);

/// In how many of the conditions' figures `method` is better than the hand-set filter, equal to it
/// within 2 %, and worse: "better in 31, equal in 12, worse in 9 of 52 figures".
std::string scoreText(const std::vector<HeldOutCondition>& conditions, const std::string& method);

}  // namespace vdamf
