// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/hits.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "matched_filter/hit_cells.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
std::uint64_t heightsOf(const Cluster& cluster)
{
    std::uint64_t all = 0;
    inWideLanes([ from = cluster.height.data(), size = cluster.height.size(), result = &
                  all ]() __attribute__((always_inline)) {
        std::uint64_t heights = 0;
        for (std::size_t i = 0; i < size; ++i)
        {
            const bool usable = (from[i] >= 0.0F) & (from[i] < 6.4F);
            const auto tenths = static_cast<std::int32_t>(10.0F * (usable ? from[i] : 0.0F));
            heights |= (usable ? std::uint64_t{1} : std::uint64_t{0}) << tenths;
        }
        *result = heights;
    });
    return all;
}
}  // namespace

Hits projectHits(const Cluster& cluster, double cellSize)
{
    Hits hits;
    const std::vector<HitCell> cells = hitCells(cluster, cellSize);
    hits.heights = heightsOf(cluster);
    if (!cluster.time.empty())
        hits.time = std::accumulate(cluster.time.begin(), cluster.time.end(), 0.0) /
                    static_cast<double>(cluster.time.size());
    for (auto* column : {&hits.x, &hits.y, &hits.weight, &hits.varianceX, &hits.covariance,
                         &hits.varianceY, &hits.height})
        column->resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
        const HitCell& cell = cells[i];
        const double n = cell.n;
        const double share = 1.0 / n;
        const double x = share * cell.sx;
        const double y = share * cell.sy;
        hits.x[i] = cell.x + x;
        hits.y[i] = cell.y + y;
        hits.weight[i] = n;
        hits.height[i] = share * cell.heights;
        hits.totalWeight += n;
        // Of hits in one place rounding may leave less than nothing.
        hits.varianceX[i] = std::max(0.0, share * cell.sxx - x * x);
        hits.covariance[i] = share * cell.sxy - x * y;
        hits.varianceY[i] = std::max(0.0, share * cell.syy - y * y);
    }
    return hits;
}

Hits joined(const Hits& a, const Hits& b)
{
    Hits all = a;
    all.x.insert(all.x.end(), b.x.begin(), b.x.end());
    all.y.insert(all.y.end(), b.y.begin(), b.y.end());
    all.weight.insert(all.weight.end(), b.weight.begin(), b.weight.end());
    all.totalWeight += b.totalWeight;
    all.heights |= b.heights;
    if (all.totalWeight > 0.0) all.time += (b.time - a.time) * b.totalWeight / all.totalWeight;
    const auto append = [&](std::vector<double>& to, const std::vector<double>& from)
    {
        if (to.empty() && from.empty()) return;
        to.resize(a.size(), 0.0);  // where only one of the two has them
        to.insert(to.end(), from.begin(), from.end());
        to.resize(all.size(), 0.0);
    };
    append(all.varianceX, b.varianceX);
    append(all.covariance, b.covariance);
    append(all.varianceY, b.varianceY);
    append(all.height, b.height);
    return all;
}

}  // namespace vdamf
