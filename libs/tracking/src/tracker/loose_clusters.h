// SPDX-License-Identifier: BSD-3-Clause
// Loose hits on what is tracked, as clusters.
#pragma once

#include <vector>

#include "tracker/sighting.h"
#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
/// The assignment of clusters to targets with the loose hits on each target (looseHitsOn) as a
/// cluster more, behind those of the frame.
std::vector<std::vector<std::size_t>> withLooseHits(
    std::vector<std::vector<std::size_t>> assignment, SegmentedFrame& frame,
    const std::vector<PredictedTarget>& targets, const TrackerOptions& options);

}  // namespace vdamf
