// SPDX-License-Identifier: BSD-3-Clause
// The rectangle along the axes around a cluster.
#pragma once

#include <cmath>

#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// m; of no hits, from far on the right to far on the left.
struct ClusterBounds
{
    float minX = 1e9F, maxX = -1e9F, minY = 1e9F, maxY = -1e9F;

    double diagonal() const
    {
        return maxX < minX ? 0.0 : static_cast<double>(std::hypot(maxX - minX, maxY - minY));
    }
};

ClusterBounds boundsOf(const Cluster& cluster);

}  // namespace vdamf
