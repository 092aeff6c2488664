// SPDX-License-Identifier: BSD-3-Clause
// Vehicles in clusters that hold something else as well, before anything is known of them.
#pragma once

#include <vector>

#include "tracker/discriminate.h"
#include "tracker/neighbourhood.h"
#include "tracker/sighting.h"
#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
/// The boxes of those pieces of a cluster (convex_pieces.h) that the discriminator is sure to be
/// vehicles, and that are no higher than cars.
std::vector<PredictedTarget> vehiclesAmong(std::vector<Cluster> pieces, const SegmentedFrame& frame,
                                           const Neighbourhood& around,
                                           const Discriminator& discriminator,
                                           const TrackerOptions& options);

}  // namespace vdamf
