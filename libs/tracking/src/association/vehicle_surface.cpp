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

std::size_t VehicleSurface::claim(const Cluster& cluster, std::int32_t vehicle, std::int32_t none,
                                  std::vector<std::int32_t>& owner) const
{
    std::int64_t count = 0;
    const bool isTimed = !cluster.time.empty();
    inWideLanes([
        =, px = cluster.x.data(), py = cluster.y.data(), size = cluster.size(),
        // Without times the hits are where they were; any numbers do.
        times = isTimed ? cluster.time.data() : cluster.x.data(),
        vx = isTimed ? velocity_.x() : 0.0, vy = isTimed ? velocity_.y() : 0.0, cx = centre_.x(),
        cy = centre_.y(), c = toBox_(0, 0), s = toBox_(0, 1), length = half_.x(), width = half_.y(),
        behind = weights_(0, 0), ahead = weights_(0, 1), right = weights_(1, 0),
        left = weights_(1, 1), owners = owner.data(), result = &count
    ]() __attribute__((always_inline)) {
        std::int64_t claimed = 0;
        VDAMF_INDEPENDENT_LANES
        for (std::size_t i = 0; i < size; ++i)
        {
            const auto time = static_cast<double>(times[i]);
            const double dx = (static_cast<double>(px[i]) - time * vx) - cx;
            const double dy = (static_cast<double>(py[i]) - time * vy) - cy;
            const double x = c * dx + s * dy;
            const double y = c * dy - s * dx;
            const double outX = std::abs(x) - length;
            const double outY = std::abs(y) - width;
            const double squareX = outX > 0.0 ? outX * outX * (x > 0.0 ? ahead : behind) : 0.0;
            const double squareY = outY > 0.0 ? outY * outY * (y > 0.0 ? left : right) : 0.0;
            const bool isClaimed = (squareX + squareY < 1.0) & (owners[i] == none);
            owners[i] = isClaimed ? vehicle : owners[i];
            claimed += isClaimed ? 1 : 0;
        }
        *result = claimed;
    });
    return static_cast<std::size_t>(count);
}

}  // namespace vdamf
