// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/range_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "preprocessing/bearing.h"
#include "types/wide_lanes.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr int kProfileSectors = 720;
constexpr float kHidingHeight = 0.6F;  // m, where heights are known
// Of sectors without hits, m: at the nearer hit beside them, and at the farther one.
constexpr double kNarrow = 0.5;
constexpr double kNarrowBehind = 1.0;

constexpr int kProfileLayers = static_cast<int>(RangeProfile::kLayers);

// Squared range and place in the profile of some of the hits above ground. Cells' bearings need be
// no better than a thousandth of a sector.
struct LocatedBlock
{
    static constexpr std::size_t kSize = 512;
    std::array<float, kSize> squaredRange;
    std::array<std::uint16_t, kSize> place;  // layer by layer

    void locate(const PointCloud& points, const std::uint32_t* index, const float* height,
                std::size_t size, const Eigen::Vector3f& sensor, float hidingHeight)
    {
        inWideLanes([
            =, px = points.x.data(), py = points.y.data(), pz = points.z.data(), sx = sensor.x(),
            sy = sensor.y(), sz = sensor.z(), squares = squaredRange.data(), places = place.data()
        ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i)
            {
                const float dx = px[index[i]] - sx;
                const float dy = py[index[i]] - sy;
                const float square = dx * dx + dy * dy;
                const bool hides = (height[i] >= hidingHeight) & (square < 1e12F);
                // From bearing -pi on: of the opposite direction from 0 on.
                const float turn = hides ? turns(-dx, -dy, FineArc()) : 0.0F;
                const int at = static_cast<int>(turn * kProfileSectors);
                const int sector = at < kProfileSectors ? at : kProfileSectors - 1;
                const float slope = (pz[index[i]] - sz) / std::sqrt(square + 1e-6F);
                const float up = (slope - static_cast<float>(RangeProfile::kLowestLayer)) /
                                 static_cast<float>(RangeProfile::kLayer);
                const float bounded =
                    up > 0.0F ? (up < kProfileLayers - 1 ? up : kProfileLayers - 1) : 0.0F;
                const int layer = static_cast<int>(bounded);
                places[i] = static_cast<std::uint16_t>(layer * kProfileSectors + sector);
                squares[i] = hides ? square : std::numeric_limits<float>::infinity();
            }
        });
    }

    // What follows the hits of the last block.
    void hideNothingFrom(std::size_t size)
    {
        std::fill(place.begin() + static_cast<std::ptrdiff_t>(size), place.end(), std::uint16_t{0});
        std::fill(squaredRange.begin() + static_cast<std::ptrdiff_t>(size), squaredRange.end(),
                  std::numeric_limits<float>::infinity());
    }
};

// Glass and paint at a grazing angle return nothing: narrow gaps between hits are no free view, and
// are as far as the farther one of those.
std::vector<float> withoutNarrowGaps(const std::vector<float>& nearest)
{
    constexpr double kSector = 2.0 * kPi / kProfileSectors;  // rad
    std::vector<float> closed = nearest;
    const std::size_t size = nearest.size();
    const auto isGap = [&](std::size_t k) { return std::isinf(nearest[k % size]); };
    for (std::size_t before = 0; before < size; ++before)
    {
        if (isGap(before) || !isGap(before + 1)) continue;
        std::size_t after = before + 1;
        while (isGap(after)) ++after;
        const auto [nearer, farther] = std::minmax(nearest[before], nearest[after % size]);
        const double angle = static_cast<double>(after - before - 1) * kSector;
        if (angle * nearer > kNarrow || angle * farther > kNarrowBehind) continue;
        for (std::size_t k = before + 1; k < after; ++k) closed[k % size] = farther;
    }
    return closed;
}
}  // namespace

RangeProfile rangeProfile(const LadarFrame& frame, const AboveGround& aboveGround)
{
    RangeProfile profile;
    std::vector<float>& above = profile.nearestAbove;
    above.assign(kProfileSectors * kProfileLayers, std::numeric_limits<float>::infinity());
    const Eigen::Vector3f sensor = (frame.sensor - frame.origin).cast<float>();
    const float hidingHeight =
        frame.planar ? -std::numeric_limits<float>::infinity() : kHidingHeight;
    LocatedBlock block;
    for (std::size_t begin = 0; begin < aboveGround.index.size(); begin += LocatedBlock::kSize)
    {
        const std::size_t size = std::min(LocatedBlock::kSize, aboveGround.index.size() - begin);
        block.locate(frame.points, &aboveGround.index[begin], &aboveGround.height[begin], size,
                     sensor, hidingHeight);
        block.hideNothingFrom(size);
        // Neighbours in a scan mostly share a place, and each would wait for the one before it to
        // be stored: hits from four parts of the block in turn do not.
        constexpr std::size_t kPart = LocatedBlock::kSize / 4;
        for (std::size_t i = 0; i < kPart; ++i)
            for (std::size_t k = i; k < LocatedBlock::kSize; k += kPart)
            {
                float& nearest = above[block.place[k]];
                nearest = std::min(nearest, block.squaredRange[k]);
            }
    }
    for (float& nearest : above) nearest = std::sqrt(nearest);
    for (std::size_t k = above.size() - kProfileSectors; k-- > 0;)
        above[k] = std::min(above[k], above[k + kProfileSectors]);
    profile.nearest = withoutNarrowGaps({above.begin(), above.begin() + kProfileSectors});
    if (frame.planar) above.clear();
    return profile;
}

}  // namespace vdamf
