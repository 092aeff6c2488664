// SPDX-License-Identifier: BSD-3-Clause
// Hits too few for a cluster of their own, on vehicles that others show: far away, seen at a
// grazing angle, or behind a wheel house, the rest of a side falls into such.
#pragma once

#include <vector>

#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// What of some hits lies on each target that has clusters (`assignment`), may be a car or van and
/// is in a known place; by target, each hit once at most. `sensor`: in the frame of the hits, m.
std::vector<Cluster> looseHitsOn(const std::vector<PredictedTarget>& targets,
                                 const std::vector<std::vector<std::size_t>>& assignment,
                                 const Cluster& loose, const Eigen::Vector2d& sensor,
                                 const AssociationOptions& options);

/// Whether any of some hits lies on a target that may be a car or van and is in a known place.
bool anyLiesOn(const PredictedTarget& target, const Cluster& hits, const Eigen::Vector2d& sensor,
               const AssociationOptions& options);

}  // namespace vdamf
