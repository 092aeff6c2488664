// SPDX-License-Identifier: BSD-3-Clause
#include "association/vehicle_surface.h"

#include <cstddef>

#include "types/cluster_bounds.h"
#include "types/lane_bounds.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
bool VehicleSurface::isOutgrownBy(const Cluster& cluster) const
{
    ClusterBounds places;
    const Eigen::Matrix2f toBox = toBox_.cast<float>();
    const Eigen::Vector2f centre = centre_.cast<float>();
    const Eigen::Vector2f velocity = velocity_.cast<float>();
    inWideLanes([
        px = cluster.x.data(), py = cluster.y.data(), size = cluster.size(),
        times = cluster.time.empty() ? nullptr : cluster.time.data(), c = toBox(0, 0),
        s = toBox(0, 1), cx = centre.x(), cy = centre.y(), vx = velocity.x(), vy = velocity.y(),
        result = &places
    ]() __attribute__((always_inline)) {
        LaneBounds<Floats> each(result->minX);
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats dx;
            Floats dy;
            Floats time{};
            loadRepeating(dx, px + first, count);
            loadRepeating(dy, py + first, count);
            if (times) loadRepeating(time, times + first, count);
            dx -= cx + vx * time;
            dy -= cy + vy * time;
            each.add(c * dx + s * dy, c * dy - s * dx);
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        each.growTo(*result);
    });
    const Eigen::Array2d lowest(places.minX, places.minY);
    const Eigen::Array2d highest(places.maxX, places.maxY);
    return (highest - lowest > most_.array()).any() || (lowest < lowest_).any() ||
           (highest > highest_).any();
}

}  // namespace vdamf
