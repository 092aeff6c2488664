// SPDX-License-Identifier: BSD-3-Clause
// A frame whose clusters are each inside one target, as far as the tracks tell.
#pragma once

#include <vector>

#include "tracker/sighting.h"
#include "vdamf/tracking/association/shared_clusters.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
/// Clusters that several targets share are cut: the first piece takes the place of the whole, the
/// others come behind all clusters.
SegmentedFrame withSharedClustersCut(SegmentedFrame frame,
                                     const std::vector<PredictedTarget>& targets,
                                     const TrackerOptions& options);

}  // namespace vdamf
