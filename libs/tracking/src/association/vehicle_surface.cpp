// SPDX-License-Identifier: BSD-3-Clause
#include "association/vehicle_surface.h"

#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
bool VehicleSurface::isOutgrownBy(const Cluster& cluster) const
{
    Eigen::Array2f min = Eigen::Array2f::Constant(1e30F);
    Eigen::Array2f max = -min;
    const Eigen::Matrix2f toBox = toBox_.cast<float>();
    const Eigen::Vector2f centre = centre_.cast<float>();
    const Eigen::Vector2f velocity = velocity_.cast<float>();
    inWideLanes([
        px = cluster.x.data(), py = cluster.y.data(), size = cluster.size(),
        times = cluster.time.empty() ? nullptr : cluster.time.data(), c = toBox(0, 0),
        s = toBox(0, 1), cx = centre.x(), cy = centre.y(), vx = velocity.x(), vy = velocity.y(),
        least = min.data(), most = max.data()
    ]() __attribute__((always_inline)) {
        Floats minX = Floats{} + least[0], maxX = -minX, minY = minX, maxY = -minX;
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
            const Floats x = c * dx + s * dy;
            const Floats y = c * dy - s * dx;
            minX = x < minX ? x : minX;
            maxX = x > maxX ? x : maxX;
            minY = y < minY ? y : minY;
            maxY = y > maxY ? y : maxY;
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        for (std::size_t k = 0; k < kLanes<Floats>; ++k)
        {
            least[0] = std::min(least[0], minX[k]);
            least[1] = std::min(least[1], minY[k]);
            most[0] = std::max(most[0], maxX[k]);
            most[1] = std::max(most[1], maxY[k]);
        }
    });
    const Eigen::Array2d lowest = min.cast<double>();
    const Eigen::Array2d highest = max.cast<double>();
    return (highest - lowest > most_.array()).any() || (lowest < lowest_).any() ||
           (highest > highest_).any();
}

}  // namespace vdamf
