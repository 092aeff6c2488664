// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/polar_grid.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
// Angle from +x in units of a full turn, within 0.004 rad: cells need no better. Without a branch
// and without a library call, so that the compiler vectorises the loop around it.
inline float turns(float x, float y)
{
    const float ax = std::abs(x);
    const float ay = std::abs(y);
    const float big = ax > ay ? ax : ay;
    const float small = ax > ay ? ay : ax;
    const float t = small / (big + 1e-9F);
    const float octant = t * (0.125F + 0.0434F * (1.0F - t));
    const float quadrant = ay > ax ? 0.25F - octant : octant;
    const float half = x < 0.0F ? 0.5F - quadrant : quadrant;
    return y < 0.0F ? 1.0F - half : half;
}
}  // namespace

PolarHits locateHits(const LadarFrame& frame, const GroundOptions& options)
{
    const auto n = static_cast<Eigen::Index>(frame.points.size());
    const Eigen::Vector3f shift = (frame.origin - frame.sensor).cast<float>();
    PolarHits hits;
    hits.x.resize(frame.points.size());
    hits.y.resize(frame.points.size());
    hits.z.resize(frame.points.size());
    hits.ring.resize(frame.points.size());
    hits.sector.resize(frame.points.size());
    using Array = Eigen::Map<Eigen::ArrayXf>;
    using Input = Eigen::Map<const Eigen::ArrayXf>;
    Array x(hits.x.data(), n);
    Array y(hits.y.data(), n);
    Array z(hits.z.data(), n);
    Array range(hits.ring.data(), n);
    x = Input(frame.points.x.data(), n) + shift.x();
    y = Input(frame.points.y.data(), n) + shift.y();
    z = Input(frame.points.z.data(), n) + shift.z();
    range = (x * x + y * y).sqrt();

    const auto minRange = static_cast<float>(options.minRange);
    const auto maxRange = static_cast<float>(options.maxRange);
    constexpr float kMaxZ = 1e4F;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const float r = hits.ring[i];
        const bool used = (r >= minRange) & (r <= maxRange) & (std::abs(hits.z[i]) < kMaxZ);
        // A hit that is not used may hold anything: no conversion to int before this.
        const float turn = used ? turns(hits.x[i], hits.y[i]) : 0.0F;
        const auto sector = static_cast<std::int32_t>(turn * PolarGrid::kSectors);
        hits.sector[i] = used ? std::min(sector, PolarGrid::kSectors - 1) : -1;
        hits.ring[i] = used ? PolarGrid::coordinate(r) : 0.0F;
    }
    return hits;
}

std::vector<LowHits> lowestHits(const PolarHits& hits, const PolarGrid& grid)
{
    std::vector<LowHits> cells(static_cast<std::size_t>(grid.cells()));
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        if (hits.sector[i] < 0) continue;
        const int cell = grid.cell(hits.sector[i], static_cast<int>(hits.ring[i]));
        LowHits& low = cells[static_cast<std::size_t>(cell)];
        const float z = hits.z[i];
        if (z >= low.second) continue;
        const auto index = static_cast<std::int32_t>(i);
        if (z < low.lowest)
        {
            low.second = low.lowest;
            low.secondIndex = low.index;
            low.lowest = z;
            low.index = index;
        }
        else
        {
            low.second = z;
            low.secondIndex = index;
        }
    }
    return cells;
}

}  // namespace vdamf
