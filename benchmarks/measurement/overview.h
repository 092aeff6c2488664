// SPDX-License-Identifier: BSD-3-Clause
// The measurement's tables as BENCHMARK.md shows them.
#pragma once

#include <string>
#include <vector>

#include "vdamf/learning/clusters/case_summary.h"

namespace vdamf
{
/// One line a condition: heading and near corner of the default and of those to compare with;
/// faces, sizes and consistency of the default. Empty cells where a method did not run.
std::string overview(const std::vector<CaseSummary>& rows);

}  // namespace vdamf
