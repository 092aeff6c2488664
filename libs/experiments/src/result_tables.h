// SPDX-License-Identifier: BSD-3-Clause
// The results of a sweep as tables of a page.
#pragma once

#include <string>

#include "vdamf/experiments/results.h"

namespace vdamf
{
/// One row a setting: its values, its means over the recordings, its time. The best one is marked.
std::string settingsTable(const SweepResults& results);

/// One row a run; failed ones say why.
std::string runsTable(const SweepResults& results);

}  // namespace vdamf
