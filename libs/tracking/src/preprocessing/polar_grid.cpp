// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/polar_grid.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
// Angle from +x in units of a full turn, within 0.004 rad: cells need no better. Without a branch
// or a call, so that the loop around it becomes vector instructions.
inline float turns(float x, float y)
{
    const float ax = std::abs(x);
    const float ay = std::abs(y);
    const float difference = ax - ay;
    const float small = 0.5F * (ax + ay - std::abs(difference));
    const float big = 0.5F * (ax + ay + std::abs(difference));
    const float t = small / (big + 1e-9F);
    const float octant = t * (0.125F + 0.0434F * (1.0F - t));
    // Mirrored at the diagonal where |y| > |x|, then at the axes.
    const float quadrant = 0.125F - std::copysign(0.125F - octant, difference);
    const float half = 0.25F - std::copysign(0.25F - quadrant, x);
    return 0.5F - std::copysign(0.5F - half, y);
}

// Height and index of a hit in one integer, so that the lowest two of a cell are two minima and
// not branches, which would go either way at every hit.
using Key = std::uint64_t;
constexpr Key kNoKey = std::numeric_limits<Key>::max();

inline Key keyOf(float z, std::size_t index)
{
    const auto millimetres = static_cast<std::int64_t>(z * 1000.0F);
    return static_cast<Key>(millimetres + (std::int64_t{1} << 30)) << 32 | index;
}
}  // namespace

PolarHits locateHits(const LadarFrame& frame, const GroundOptions& options)
{
    const PointCloud& points = frame.points;
    const std::size_t size = points.size();
    const auto n = static_cast<Eigen::Index>(size);
    PolarHits hits{(frame.origin - frame.sensor).cast<float>(), {}, {}};
    const float dx = hits.shift.x();
    const float dy = hits.shift.y();
    hits.ring.resize(size);
    hits.sector.resize(size);
    // Eigen's square root is a vector instruction; the library's has a branch for errno.
    Eigen::Map<Eigen::ArrayXf>(hits.ring.data(), n) =
        ((Eigen::Map<const Eigen::ArrayXf>(points.x.data(), n) + dx).square() +
         (Eigen::Map<const Eigen::ArrayXf>(points.y.data(), n) + dy).square())
            .sqrt();

    const auto minRange = static_cast<float>(options.minRange);
    const auto maxRange = static_cast<float>(options.maxRange);
    constexpr float kMaxZ = 1e4F;
    // Plain pointers and selections instead of branches: so the loop becomes vector instructions.
    const float* const px = points.x.data();
    const float* const py = points.y.data();
    const float* const pz = points.z.data();
    float* const ring = hits.ring.data();
    std::uint8_t* const sector = hits.sector.data();
    for (std::size_t i = 0; i < size; ++i)
    {
        const float range = ring[i];
        const bool used = (range >= minRange) & (range <= maxRange) & (std::abs(pz[i]) < kMaxZ);
        const float unusedOffset = used ? 0.0F : -1000.0F;
        // A hit that is not used may hold anything: only numbers in range get to be an int.
        const float turn = turns(px[i] + dx, py[i] + dy) * PolarGrid::kSectors;
        sector[i] = static_cast<std::uint8_t>(static_cast<int>(turn > 0.0F ? turn : 0.0F));
        ring[i] = PolarGrid::coordinate(range < maxRange ? range : maxRange) + unusedOffset;
    }
    return hits;
}

std::vector<LowHits> lowestHits(const PointCloud& points, const PolarHits& hits,
                                const PolarGrid& grid)
{
    const auto cells = static_cast<std::size_t>(grid.cells());
    std::vector<std::array<Key, 2>> keys(cells, {kNoKey, kNoKey});
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (hits.ring[i] < 0.0F) continue;
        const int cell = grid.cell(hits.sector[i], static_cast<int>(hits.ring[i]));
        auto& low = keys[static_cast<std::size_t>(cell)];
        const Key key = keyOf(points.z[i], i);
        // Exchanges key and low[0] where key is less, by arithmetic.
        const Key exchange = (key ^ low[0]) & (Key{0} - static_cast<Key>(key < low[0]));
        low[0] ^= exchange;
        low[1] = std::min(low[1], key ^ exchange);
    }
    std::vector<LowHits> lowHits(cells);
    for (std::size_t cell = 0; cell < cells; ++cell)
        for (std::size_t k = 0; k < 2 && keys[cell][k] != kNoKey; ++k)
        {
            const auto i = static_cast<std::size_t>(keys[cell][k] & 0xFFFFFFFFU);
            lowHits[cell][k] = {points.z[i] + hits.shift.z(), points.x[i] + hits.shift.x(),
                                points.y[i] + hits.shift.y()};
        }
    return lowHits;
}

}  // namespace vdamf
