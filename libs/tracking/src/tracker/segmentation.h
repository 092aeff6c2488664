// SPDX-License-Identifier: BSD-3-Clause
// From the hits above the ground to clusters, and what the sensor sees past them.
#pragma once

#include "tracker/field_of_view.h"
#include "tracker/sighting.h"
#include "tracker/worker_pool.h"
#include "vdamf/tracking/preprocessing/clustering.h"
#include "vdamf/tracking/preprocessing/ground.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// The clusters of a frame, of any extent: a car before a wall is in one with it. Their hits are
/// not projected yet.
SegmentedFrame segmentedFrame(const LadarFrame& frame, const AboveGround& above,
                              const FieldOfView& view, ClusterOptions options);

/// The clusters of some hits of a frame, of any extent, and what is in none: where others were cut
/// out, the rest may fall into several.
ClusteredHits clusteredAnew(Cluster hits, const SegmentedFrame& frame, ClusterOptions options);

/// The frame with the hits of all its clusters projected.
SegmentedFrame withHits(SegmentedFrame frame, const MeasureOptions& options, WorkerPool& workers);

}  // namespace vdamf
