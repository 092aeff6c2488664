// SPDX-License-Identifier: BSD-3-Clause
#include "types/cluster_bounds.h"

#include "types/wide_lanes.h"

namespace vdamf
{
ClusterBounds boundsOf(const Cluster& cluster)
{
    ClusterBounds bounds;
    inWideLanes([ x = cluster.x.data(), y = cluster.y.data(), size = cluster.size(), &bounds ]()
                    __attribute__((always_inline)) {
                        ClusterBounds b;
                        for (std::size_t i = 0; i < size; ++i)
                        {
                            b.minX = x[i] < b.minX ? x[i] : b.minX;
                            b.maxX = x[i] > b.maxX ? x[i] : b.maxX;
                            b.minY = y[i] < b.minY ? y[i] : b.minY;
                            b.maxY = y[i] > b.maxY ? y[i] : b.maxY;
                        }
                        bounds = b;
                    });
    return bounds;
}

}  // namespace vdamf
