// SPDX-License-Identifier: BSD-3-Clause
// Section 2 wants each cluster inside at most one target. Vehicles that pass close to each other
// may come as one cluster all the same: their predicted boxes tell which hit is whose.
#pragma once

#include <cstddef>
#include <vector>

#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// A cluster with hits of several targets.
struct SharedCluster
{
    std::size_t cluster = 0;
    std::vector<std::size_t> targets;  ///< rising, two or more
};

/// Clusters that one target alone does not explain: a tenth of their hits, and five at least, are
/// on the surface of another target and not on that of the first, and as many the other way round
/// (of vehicles for sure half of the hits that they had before are enough).
/// Targets count whose place is known well and whose boxes do not overlap, those of vehicles for
/// sure not by more than 0.3 m, so that two tracks on one vehicle do not share it.
std::vector<SharedCluster> sharedClusters(const std::vector<PredictedTarget>& targets,
                                          const std::vector<Hits>& clusters,
                                          const AssociationOptions& options);

/// The cluster in pieces, one for each of the targets (those without a hit left out): every hit
/// goes to the target whose predicted box is nearest in standard deviations. `time`: of the
/// cluster, s after the frame's (Hits::time).
std::vector<Cluster> cutBetween(const Cluster& cluster, const std::vector<PredictedTarget>& targets,
                                double time, const AssociationOptions& options);

}  // namespace vdamf
