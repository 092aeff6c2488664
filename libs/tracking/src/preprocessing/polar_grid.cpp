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
constexpr float kMaxZ = 1e4F;  // m; a hit beyond it is not used

// Of some of the hits: millimetres above a depth that no hit reaches; the greatest where not used.
struct Elevations
{
    static constexpr std::size_t kSize = 256;
    std::array<std::uint32_t, kSize> each;

    void of(const PointCloud& points, const PolarHits& hits, std::size_t begin, std::size_t size)
    {
        inWideLanes([
            =, pz = points.z.data() + begin, ring = hits.ring.data() + begin,
            elevation = each.data()
        ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i)
            {
                const bool used = ring[i] >= 0.0F;
                const auto millimetres = static_cast<std::int32_t>((used ? pz[i] : 0.0F) * 1000.0F);
                constexpr std::uint32_t kLowest = 1U << 30;
                elevation[i] =
                    used ? static_cast<std::uint32_t>(millimetres) + kLowest : kNoElevation;
            }
        });
    }
};

// The two lowest hits of each cell.
class LowestKeys
{
public:
    explicit LowestKeys(std::size_t cells) : keys_(cells, {kNoKey, kNoKey}) {}

    void take(std::size_t cell, std::uint32_t elevation, std::size_t hit)
    {
        auto& low = keys_[cell];
        const Key key = Key{elevation} << 32 | hit;
        // Exchanges key and low[0] where key is less, by arithmetic.
        const Key exchange = (key ^ low[0]) & (Key{0} - static_cast<Key>(key < low[0]));
        low[0] ^= exchange;
        low[1] = std::min(low[1], key ^ exchange);
    }

    const std::array<Key, 2>& at(std::size_t cell) const { return keys_[cell]; }

private:
    std::vector<std::array<Key, 2>> keys_;
};

LowestKeys lowestKeys(const PointCloud& points, const PolarHits& hits, std::size_t cells)
{
    LowestKeys keys(cells);
    const std::uint16_t* const cell = hits.cell.data();
    // Neighbours in a scan mostly share a cell, and each would wait for the one before it to be
    // stored: hits from four parts of the scan in turn do not.
    constexpr std::size_t kParts = 4;
    std::array<Elevations, kParts> elevations;
    const std::size_t part = points.size() / kParts;
    for (std::size_t begin = 0; begin < part; begin += Elevations::kSize)
    {
        const std::size_t size = std::min(Elevations::kSize, part - begin);
        for (std::size_t k = 0; k < kParts; ++k)
            elevations[k].of(points, hits, begin + k * part, size);
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t k = 0; k < kParts; ++k)
            {
                const std::size_t hit = begin + i + k * part;
                keys.take(cell[hit], elevations[k].each[i], hit);
            }
    }
    const std::size_t rest = points.size() - kParts * part;
    elevations[0].of(points, hits, kParts * part, rest);
    for (std::size_t i = 0; i < rest; ++i)
        keys.take(cell[kParts * part + i], elevations[0].each[i], kParts * part + i);
    return keys;
}
}  // namespace

PolarHits locateHits(const LadarFrame& frame, const GroundOptions& options)
{
    const PointCloud& points = frame.points;
    const std::size_t size = points.size();
    PolarHits hits{(frame.origin - frame.sensor).cast<float>(), {}, {}};
    hits.ring.resize(static_cast<Eigen::Index>(size));
    hits.cell.resize(static_cast<Eigen::Index>(size));
    const auto minRange = static_cast<float>(options.minRange);
    const auto maxRange = static_cast<float>(options.maxRange);
    // Selections instead of branches: so the loop becomes vector instructions.
    inWideLanes([
        =, px = points.x.data(), py = points.y.data(), pz = points.z.data(),
        ring = hits.ring.data(), cell = hits.cell.data(), dx = hits.shift.x(), dy = hits.shift.y()
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
        }
    });
    return hits;
}

LowHits lowestHits(const PointCloud& points, const PolarHits& hits, const PolarGrid& grid)
{
    const auto cells = static_cast<std::size_t>(grid.cells());
    const LowestKeys keys = lowestKeys(points, hits, cells);
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
        put(low.lowest, cell, keys.at(cell)[0]);
        put(low.second, cell, keys.at(cell)[1]);
    }
    return low;
}

}  // namespace vdamf
