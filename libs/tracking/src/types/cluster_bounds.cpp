// SPDX-License-Identifier: BSD-3-Clause
#include "types/cluster_bounds.h"

#include <algorithm>
#include <cstddef>

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
        const ClusterBounds none;
        Floats minX = Floats{} + none.minX, maxX = Floats{} + none.maxX, minY = minX, maxY = maxX;
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats x;
            Floats y;
            loadRepeating(x, px + first, count);
            loadRepeating(y, py + first, count);
            minX = x < minX ? x : minX;
            maxX = x > maxX ? x : maxX;
            minY = y < minY ? y : minY;
            maxY = y > maxY ? y : maxY;
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        for (std::size_t k = 0; k < kLanes<Floats>; ++k)
            *result = {std::min(result->minX, minX[k]), std::max(result->maxX, maxX[k]),
                       std::min(result->minY, minY[k]), std::max(result->maxY, maxY[k])};
    });
    return bounds;
}

}  // namespace vdamf
