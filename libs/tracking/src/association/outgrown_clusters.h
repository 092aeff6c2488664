// SPDX-License-Identifier: BSD-3-Clause
// Clusters that hold a vehicle and what stands beside it, as a hedge or a wall: the vehicle's box
// tells which hits are its own.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "association/plane_index.h"
#include "types/cluster_bounds.h"
#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// A cluster in parts.
struct CutCluster
{
    std::vector<Cluster> vehicles;  ///< what lies on each
    Cluster rest;
};

/// Vehicles whose place and size are known.
class KnownVehicles
{
public:
    /// Those of the targets.
    KnownVehicles(const std::vector<PredictedTarget>& targets, const AssociationOptions& options);

    /// What lies on the vehicles and what does not, where a cluster reaches farther beyond one of
    /// them than its size may err, and there are hits enough of both. Else nothing. `bounds`: of
    /// the cluster; `sensor`: in the frame of the hits, m.
    std::optional<CutCluster> cut(const Cluster& cluster, const ClusterBounds& bounds,
                                  const Eigen::Vector2d& sensor) const;

private:
    AssociationOptions options_;
    std::vector<PredictedTarget> vehicles_;
    PlaneIndex index_;
};

}  // namespace vdamf
