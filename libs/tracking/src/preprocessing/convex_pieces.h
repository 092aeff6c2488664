// SPDX-License-Identifier: BSD-3-Clause
// What the sensor sees of a vehicle bulges towards it: where a cluster's outline is dented, two
// things meet.
#pragma once

#include <vector>

#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// The hits of a cluster that are nearest to the sensor by bearing, and those close behind them,
/// cut where their outline is dented, counter-clockwise. Nothing where it has no dents.
std::vector<Cluster> convexPieces(const Cluster& cluster, const Eigen::Vector2d& sensor);

}  // namespace vdamf
