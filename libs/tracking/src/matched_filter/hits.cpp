// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/hits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vdamf
{
namespace
{
struct CellHit
{
    std::int64_t cell;
    float x, y;
};

// Hits with the number of their cell, by rising cell; cellSize 0: a cell of its own for each.
std::vector<CellHit> sortedIntoCells(const Cluster& cluster, double cellSize)
{
    std::vector<CellHit> all;
    all.reserve(cluster.size());
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const float x = cluster.x[i];
        const float y = cluster.y[i];
        // Beyond this a cell number would not fit; no sensor reaches there. Drops NaN as well.
        if (!(std::abs(x) < 1e7F && std::abs(y) < 1e7F)) continue;
        auto cell = static_cast<std::int64_t>(all.size());
        if (cellSize > 0.0)
        {
            const auto column = static_cast<std::int64_t>(std::floor(x / cellSize));
            const auto row = static_cast<std::int64_t>(std::floor(y / cellSize));
            cell = row * (std::int64_t{1} << 32) + column;
        }
        all.push_back({cell, x, y});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const CellHit& a, const CellHit& b) { return a.cell < b.cell; });
    return all;
}
}  // namespace

Hits projectHits(const Cluster& cluster, double cellSize)
{
    const std::vector<CellHit> all = sortedIntoCells(cluster, cellSize);
    Hits hits;
    for (std::size_t i = 0; i < all.size();)
    {
        double sumX = 0.0;
        double sumY = 0.0;
        std::size_t end = i;
        for (; end < all.size() && all[end].cell == all[i].cell; ++end)
        {
            sumX += all[end].x;
            sumY += all[end].y;
        }
        const auto n = static_cast<double>(end - i);
        hits.x.push_back(sumX / n);
        hits.y.push_back(sumY / n);
        hits.weight.push_back(n);
        hits.totalWeight += n;
        i = end;
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
    return all;
}

}  // namespace vdamf
