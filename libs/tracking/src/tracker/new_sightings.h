// SPDX-License-Identifier: BSD-3-Clause
// From the clusters that no track has taken to first sightings of new targets.
#pragma once

#include <vector>

#include "tracker/neighbourhood.h"
#include "tracker/sighting.h"
#include "tracker/worker_pool.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
/// One for each cluster not `claimed` that is large enough for a target. Two clusters on both sides
/// of the seam of a turning scanner's revolution, near enough to be one target that moved between
/// them, give one sighting, of the larger one.
std::vector<Sighting> newSightings(const SegmentedFrame& frame, const std::vector<bool>& claimed,
                                   const Neighbourhood& around, const TrackerOptions& options,
                                   WorkerPool& workers);

/// Whether a cluster is high enough to start a track; level scanners do not tell heights.
bool isHighEnough(const Cluster& cluster, bool isPlanar, const LifecycleOptions& options);

/// With length and width exchanged where the sizes seen and the vehicles around say so, and front
/// and rear where the shape does.
Sighting withLikelierAxes(Sighting sighting, const Neighbourhood& around,
                          const TrackerOptions& options);

}  // namespace vdamf
