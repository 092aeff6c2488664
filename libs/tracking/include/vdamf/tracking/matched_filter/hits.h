// SPDX-License-Identifier: BSD-3-Clause
// From the hits of clusters to the signal of section 3.
#pragma once

#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/hits.h"

namespace vdamf
{
/// Projects clusters into the plane and merges the hits of each cell of `cellSize` (m, 0: no
/// merging) into their mean. Hits that are not finite are dropped.
Hits projectHits(const Cluster& cluster, double cellSize);

/// The hits of both.
Hits joined(const Hits& a, const Hits& b);

}  // namespace vdamf
