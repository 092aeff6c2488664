// SPDX-License-Identifier: BSD-3-Clause
// Vehicles without what stands so close to them that it shares their clusters.
#pragma once

#include <vector>

#include "tracker/discriminate.h"
#include "tracker/neighbourhood.h"
#include "tracker/sighting.h"
#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
/// First newcomers are cut off (newcomers.h). Clusters whose outline is dented are searched for
/// cars: those of the tracks that they outgrow, and those that show between the dents. Where known
/// clutter lies in one without dents, such tracks tell as well which hits are theirs, and those of
/// vehicles that drive, whose way tells how they lie, tell it of any cluster. What lies on
/// one comes behind all clusters, marked as a vehicle's, and what does not is clustered anew. Then
/// what is longer than [clustering] max_extent_m is dropped.
///
/// `targets`: of the tracks, in their order. No new cars are looked for in clutter that is passed
/// over in this frame (isPassedOver), by the oldest track in it.
SegmentedFrame withVehiclesCutOut(SegmentedFrame frame, const std::vector<PredictedTarget>& targets,
                                  const std::vector<Track>& tracks, const Neighbourhood& around,
                                  const Discriminator& discriminator,
                                  const TrackerOptions& options);

}  // namespace vdamf
