// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/polar_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "preprocessing/bearing.h"
#include "types/wide_lanes.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
// Elevation and index of a hit in one integer, so that the lowest two of a cell are two minima and
// not branches, which would go either way at every hit.
using Key = std::uint64_t;
constexpr std::uint32_t kNoElevation = std::numeric_limits<std::uint32_t>::max();
constexpr Key kNoKey = std::numeric_limits<Key>::max();
}  // namespace

PolarHits locateHits(const LadarFrame& frame, const GroundOptions& options)
{
    const PointCloud& points = frame.points;
    const std::size_t size = points.size();
    PolarHits hits{(frame.origin - frame.sensor).cast<float>(), {}, {}, {}};
    hits.ring.resize(size);
    hits.cell.resize(size);
    hits.elevation.resize(size);
    const auto minRange = static_cast<float>(options.minRange);
    const auto maxRange = static_cast<float>(options.maxRange);
    constexpr float kMaxZ = 1e4F;
    // Selections instead of branches: so the loop becomes vector instructions.
    inWideLanes([
        =, px = points.x.data(), py = points.y.data(), pz = points.z.data(),
        ring = hits.ring.data(), cell = hits.cell.data(), elevation = hits.elevation.data(),
        dx = hits.shift.x(), dy = hits.shift.y()
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t i = 0; i < size; ++i)
        {
            const float x = px[i] + dx;
            const float y = py[i] + dy;
            const float range = std::sqrt(x * x + y * y);
            const bool used = (range >= minRange) & (range <= maxRange) & (std::abs(pz[i]) < kMaxZ);
            // A hit that is not used may hold anything: only numbers in range get to be ints.
            const float turn = used ? turns(x, y, RoughArc()) * PolarGrid::kSectors : 0.0F;
            const float coordinate = PolarGrid::coordinate(used ? range : 0.0F);
            const int sector = static_cast<int>(turn) & (PolarGrid::kSectors - 1);
            cell[i] =
                static_cast<std::uint16_t>(PolarGrid::cell(sector, static_cast<int>(coordinate)));
            ring[i] = used ? coordinate : -1000.0F;
            const auto millimetres = static_cast<std::int32_t>((used ? pz[i] : 0.0F) * 1000.0F);
            constexpr std::uint32_t kLowest = 1U << 30;
            elevation[i] = used ? static_cast<std::uint32_t>(millimetres) + kLowest : kNoElevation;
        }
    });
    return hits;
}

LowHits lowestHits(const PointCloud& points, const PolarHits& hits, const PolarGrid& grid)
{
    const auto cells = static_cast<std::size_t>(grid.cells());
    std::vector<std::array<Key, 2>> keys(cells, {kNoKey, kNoKey});
    const auto take = [&](std::size_t i)
    {
        auto& low = keys[hits.cell[i]];
        const Key key = Key{hits.elevation[i]} << 32 | i;
        // Exchanges key and low[0] where key is less, by arithmetic.
        const Key exchange = (key ^ low[0]) & (Key{0} - static_cast<Key>(key < low[0]));
        low[0] ^= exchange;
        low[1] = std::min(low[1], key ^ exchange);
    };
    // Neighbours in a scan mostly share a cell, and each would wait for the one before it to be
    // stored: hits from four parts of the scan in turn do not.
    const std::size_t part = points.size() / 4;
    for (std::size_t i = 0; i < part; ++i)
        for (std::size_t k = 0; k < 4; ++k) take(i + k * part);
    for (std::size_t i = 4 * part; i < points.size(); ++i) take(i);

    LowHits low{CellHits(cells), CellHits(cells)};
    const auto put = [&](CellHits& to, std::size_t cell, Key key)
    {
        if (key >> 32 == kNoElevation) return;
        const auto i = static_cast<std::size_t>(key & 0xFFFFFFFFU);
        to.z[cell] = points.z[i] + hits.shift.z();
        to.x[cell] = points.x[i] + hits.shift.x();
        to.y[cell] = points.y[i] + hits.shift.y();
    };
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
        put(low.lowest, cell, keys[cell][0]);
        put(low.second, cell, keys[cell][1]);
    }
    return low;
}

}  // namespace vdamf
