// SPDX-License-Identifier: BSD-3-Clause
#include "types/cluster_bounds.h"

#include <cstddef>

#include "types/lane_bounds.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
ClusterBounds boundsOf(const Cluster& cluster)
{
    ClusterBounds bounds;
    inWideLanes([
        px = cluster.x.data(), py = cluster.y.data(), size = cluster.size(), result = &bounds
    ]() __attribute__((always_inline)) {
        LaneBounds<Floats> each(result->minX);
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats x;
            Floats y;
            loadRepeating(x, px + first, count);
            loadRepeating(y, py + first, count);
            each.add(x, y);
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        each.growTo(*result);
    });
    return bounds;
}

}  // namespace vdamf
