// SPDX-License-Identifier: BSD-3-Clause
// Which hits of a frame are those of a labelled vehicle.
#pragma once

#include <vector>

#include "vdamf/tracking/preprocessing/ground.h"
#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// The hits above ground in the label's box grown by 0.3 m. Box relative to the frame's origin.
Cluster hitsInLabel(const LadarFrame& frame, const AboveGround& above, const OrientedBox& box);

/// The cluster with most hits in the label's box; empty where none has any.
Cluster clusterOnLabel(const std::vector<Cluster>& clusters, const OrientedBox& box);

}  // namespace vdamf
