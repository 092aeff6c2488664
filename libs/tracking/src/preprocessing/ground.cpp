// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/ground.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "preprocessing/ground_surface.h"
#include "types/wide_lanes.h"

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

// How high the hits of a part of the frame lie over the surface, and which of them are kept.
struct Block
{
    static constexpr std::size_t kSize = 512;
    std::array<float, kSize> height;
    std::array<std::uint32_t, kSize> kept;

    void measure(const GroundSurface& surface, const PolarHits& hits, const PointCloud& points,
                 std::size_t begin, std::size_t size, float minHeight, float maxHeight)
    {
        inWideLanes([
            =, plane = surface.plane, ground = surface.height.data(),
            ring = hits.ring.data() + begin, cell = hits.cell.data() + begin,
            px = points.x.data() + begin, py = points.y.data() + begin,
            pz = points.z.data() + begin, dx = hits.shift.x(), dy = hits.shift.y(),
            dz = hits.shift.z(), heights = height.data(), keep = kept.data()
        ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i)
            {
                const float coordinate = ring[i] > 0.0F ? ring[i] : 0.0F;
                const float part = coordinate - static_cast<float>(static_cast<int>(coordinate));
                const int edge = cell[i];
                const float inner = ground[edge];
                const float outer = ground[edge + PolarGrid::kSectors];
                const float over =
                    pz[i] + dz - plane.at(px[i] + dx, py[i] + dy) - inner - part * (outer - inner);
                heights[i] = over;
                keep[i] = ((ring[i] >= 0.0F) & (over >= minHeight) & (over <= maxHeight)) ? 1U : 0U;
            }
        });
    }

    // Those whose times (s) are finite; there are at least as many as in the block.
    void keepTimed(const float* times, std::size_t size)
    {
        inWideLanes([ =, keep = kept.data() ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i) keep[i] &= times[i] - times[i] == 0.0F ? 1U : 0U;
        });
    }
};

AboveGround hitsBetween(const GroundSurface& surface, const PolarHits& hits,
                        const PointCloud& points, float minHeight, float maxHeight)
{
    AboveGround above;
    above.index.reserve(points.size());
    above.height.reserve(points.size());
    Block block;
    std::array<std::uint32_t, Block::kSize> index;
    for (std::size_t begin = 0; begin < points.size(); begin += Block::kSize)
    {
        const std::size_t size = std::min(Block::kSize, points.size() - begin);
        block.measure(surface, hits, points, begin, size, minHeight, maxHeight);
        if (!points.time.empty()) block.keepTimed(points.time.data() + begin, size);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size; ++i)
        {
            // Written always, counted when kept: hits change sides too often for a branch.
            index[kept] = static_cast<std::uint32_t>(begin + i);
            block.height[kept] = block.height[i];
            kept += block.kept[i];
        }
        above.index.insert(above.index.end(), index.data(), index.data() + kept);
        above.height.insert(above.height.end(), block.height.data(), block.height.data() + kept);
    }
    return above;
}
}  // namespace

AboveGround removeGround(const LadarFrame& frame, const GroundOptions& options)
{
    const PolarGrid grid(options.maxRange);
    const PolarHits hits = locateHits(frame, options);
    const auto allInRange = [&]
    { return hitsBetween(levelSurface(grid, options), hits, frame.points, -1e9F, 1e9F); };
    if (frame.planar) return allInRange();
    const LowHits low = lowestHits(frame.points, hits, grid);
    const auto plane = findGroundPlane(grid, low, options);
    if (!plane) return allInRange();
    return hitsBetween(followGround(grid, low, *plane), hits, frame.points,
                       static_cast<float>(options.minHeight),
                       static_cast<float>(options.maxHeight));
}

}  // namespace vdamf
