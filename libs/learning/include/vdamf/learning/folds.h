// SPDX-License-Identifier: BSD-3-Clause
// Splits tracks for cross-validation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vdamf/learning/sample.h"

namespace vdamf
{
/// The fold, 0 to folds - 1, of each track. Tracks of one group share a fold; folds have about
/// equal numbers of frames with vehicles and of frames with clutter. The same seed gives the same
/// folds.
std::vector<int> foldsOf(const std::vector<TrackSamples>& tracks, int folds, std::uint64_t seed);

}  // namespace vdamf
