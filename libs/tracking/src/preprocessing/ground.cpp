// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/ground.h"

#include <algorithm>

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

AboveGround hitsBetween(const PolarHits& hits, const GroundSurface& surface, float minHeight,
                        float maxHeight, int rings)
{
    AboveGround above;
    above.index.resize(hits.size());
    above.height.resize(hits.size());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const std::int32_t sector = hits.sector[i];
        const auto ring = static_cast<std::int32_t>(hits.ring[i]);
        const float part = hits.ring[i] - static_cast<float>(ring);
        // Hits that are not used read the first edge of all, and are left out below.
        const std::int32_t edge = std::max(sector, 0) * (rings + 1) + ring;
        const float* ground = &surface.height[static_cast<std::size_t>(edge)];
        const float height = hits.z[i] - surface.plane.at(hits.x[i], hits.y[i]) - ground[0] -
                             part * (ground[1] - ground[0]);
        // Written always, counted when kept: hits change sides too often to predict a branch.
        above.index[kept] = static_cast<std::uint32_t>(i);
        above.height[kept] = height;
        kept += static_cast<std::size_t>((sector >= 0) & (height >= minHeight) &
                                         (height <= maxHeight));
    }
    above.index.resize(kept);
    above.height.resize(kept);
    return above;
}
}  // namespace

AboveGround removeGround(const LadarFrame& frame, const GroundOptions& options)
{
    const PolarGrid grid(options.maxRange);
    const PolarHits hits = locateHits(frame, options);
    const std::vector<LowHits> low = lowestHits(hits, grid);
    const auto plane = findGroundPlane(hits, grid, low, options);
    if (!plane)
        return hitsBetween(hits, levelSurface(grid, options), -1e9F, 1e9F, grid.rings);
    return hitsBetween(hits, followGround(hits, grid, low, *plane),
                       static_cast<float>(options.minHeight),
                       static_cast<float>(options.maxHeight), grid.rings);
}

}  // namespace vdamf
