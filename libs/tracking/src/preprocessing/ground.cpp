// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/ground.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "preprocessing/ground_surface.h"

namespace vdamf
{
namespace
{
// A level surface for frames that show no ground.
GroundSurface levelSurface(const PolarGrid& grid, const GroundOptions& options)
{
    const auto entries = static_cast<std::size_t>(PolarGrid::kSectors * (grid.rings + 1));
    const auto height = static_cast<float>(-options.assumedSensorHeight);
    return {{height, 0.0F, 0.0F}, std::vector<float>(entries, 0.0F)};
}

// Height of a hit over the surface; for a hit that is not used, whatever.
float heightOver(const GroundSurface& surface, const PolarHits& hits, const PointCloud& points,
                 std::size_t i, int rings)
{
    const float coordinate = std::max(hits.ring[i], 0.0F);
    const auto ring = static_cast<int>(coordinate);
    const float part = coordinate - static_cast<float>(ring);
    const float* ground =
        &surface.height[static_cast<std::size_t>(hits.sector[i] * (rings + 1) + ring)];
    const float plane =
        surface.plane.at(points.x[i] + hits.shift.x(), points.y[i] + hits.shift.y());
    return points.z[i] + hits.shift.z() - plane - ground[0] - part * (ground[1] - ground[0]);
}

AboveGround hitsBetween(const GroundSurface& surface, const PolarHits& hits,
                        const PointCloud& points, float minHeight, float maxHeight, int rings)
{
    AboveGround above;
    above.index.reserve(points.size());
    above.height.reserve(points.size());
    constexpr std::size_t kBlock = 512;
    std::array<std::uint32_t, kBlock> index;
    std::array<float, kBlock> heights;
    for (std::size_t begin = 0; begin < points.size(); begin += kBlock)
    {
        const std::size_t end = std::min(begin + kBlock, points.size());
        std::ptrdiff_t kept = 0;
        for (std::size_t i = begin; i < end; ++i)
        {
            const float height = heightOver(surface, hits, points, i, rings);
            // Written always, counted when kept: hits change sides too often for a branch.
            index[static_cast<std::size_t>(kept)] = static_cast<std::uint32_t>(i);
            heights[static_cast<std::size_t>(kept)] = height;
            kept += static_cast<std::ptrdiff_t>((hits.ring[i] >= 0.0F) & (height >= minHeight) &
                                                (height <= maxHeight));
        }
        above.index.insert(above.index.end(), index.begin(), index.begin() + kept);
        above.height.insert(above.height.end(), heights.begin(), heights.begin() + kept);
    }
    return above;
}
}  // namespace

AboveGround removeGround(const LadarFrame& frame, const GroundOptions& options)
{
    const PolarGrid grid(options.maxRange);
    const PolarHits hits = locateHits(frame, options);
    const auto allInRange = [&] {
        return hitsBetween(levelSurface(grid, options), hits, frame.points, -1e9F, 1e9F,
                           grid.rings);
    };
    if (frame.planar) return allInRange();
    const std::vector<LowHits> low = lowestHits(frame.points, hits, grid);
    const auto plane = findGroundPlane(grid, low, options);
    if (!plane) return allInRange();
    return hitsBetween(followGround(grid, low, *plane), hits, frame.points,
                       static_cast<float>(options.minHeight), static_cast<float>(options.maxHeight),
                       grid.rings);
}

}  // namespace vdamf
