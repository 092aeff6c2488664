// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/hits.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace vdamf
{
namespace
{
// The hits of one cell: sums about its first one, because far from the origin squares would lose
// their digits.
struct Cell
{
    float x, y;  // the first hit
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;

    void add(float px, float py)
    {
        const double dx = static_cast<double>(px) - x;
        const double dy = static_cast<double>(py) - y;
        n += 1.0;
        sx += dx;
        sy += dy;
        sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
};

// Beyond this a cell number would not fit; no sensor reaches there. False for NaN as well.
bool isUsable(float x, float y)
{
    return std::abs(x) < 1e7F && std::abs(y) < 1e7F;
}

std::uint64_t heightsOf(const Cluster& cluster)
{
    std::uint64_t heights = 0;
    for (const float height : cluster.height)
        if (height >= 0.0F && height < 6.4F)
            heights |= std::uint64_t{1} << static_cast<unsigned>(10.0F * height);
    return heights;
}

// std::floor() calls into the library where the processor's own rounding may not be assumed.
std::int64_t floorOf(double value)
{
    const auto truncated = static_cast<std::int64_t>(value);
    return truncated - (value < static_cast<double>(truncated) ? 1 : 0);
}

// Finds the cell of a hit by its column and row: open addressing, so that the cost is one look a
// hit however large the cluster is. The table grows with the cells, of which there are far fewer
// than hits: a small one stays in the nearest cache.
class CellFinder
{
public:
    explicit CellFinder(double cellSize) : perMetre_(1.0 / cellSize), slots_(256) {}

    // The number of the hit's cell; `next` where it is the first hit of a new one.
    std::size_t find(float x, float y, std::size_t next)
    {
        if (2 * next >= slots_.size()) grow();
        const std::int64_t column = floorOf(x * perMetre_);
        const std::int64_t row = floorOf(y * perMetre_);
        const Slot wanted{row * (std::int64_t{1} << 32) + column, column + row * 0x9e3779b1, next};
        Slot& slot = slotFor(wanted);
        if (slot.cell == kFree) slot = wanted;
        return slot.cell;
    }

private:
    static constexpr std::size_t kFree = static_cast<std::size_t>(-1);
    struct Slot
    {
        std::int64_t key = 0;
        std::int64_t hash = 0;
        std::size_t cell = kFree;
    };

    // The one with the wanted key or, if there is none, the one to put it.
    Slot& slotFor(const Slot& wanted)
    {
        const std::size_t mask = slots_.size() - 1;
        auto at = static_cast<std::size_t>(wanted.hash) & mask;
        while (slots_[at].cell != kFree && slots_[at].key != wanted.key) at = (at + 1) & mask;
        return slots_[at];
    }

    void grow()
    {
        std::vector<Slot> old(2 * slots_.size());
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.cell != kFree) slotFor(slot) = slot;
    }

    double perMetre_;
    std::vector<Slot> slots_;
};

// By their first hits; cellSize 0: a cell of its own for each.
std::vector<Cell> cellsOf(const Cluster& cluster, double cellSize)
{
    std::vector<Cell> cells;
    std::optional<CellFinder> finder;
    if (cellSize > 0.0)
        finder.emplace(cellSize);
    else
        cells.reserve(cluster.size());
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const float x = cluster.x[i];
        const float y = cluster.y[i];
        if (!isUsable(x, y)) continue;
        const std::size_t cell = finder ? finder->find(x, y, cells.size()) : cells.size();
        if (cell == cells.size()) cells.push_back({x, y});
        cells[cell].add(x, y);
    }
    return cells;
}
}  // namespace

Hits projectHits(const Cluster& cluster, double cellSize)
{
    Hits hits;
    const std::vector<Cell> cells = cellsOf(cluster, cellSize);
    hits.heights = heightsOf(cluster);
    for (auto* column :
         {&hits.x, &hits.y, &hits.weight, &hits.varianceX, &hits.covariance, &hits.varianceY})
        column->reserve(cells.size());
    for (const Cell& cell : cells)
    {
        const double x = cell.sx / cell.n;
        const double y = cell.sy / cell.n;
        hits.x.push_back(cell.x + x);
        hits.y.push_back(cell.y + y);
        hits.weight.push_back(cell.n);
        hits.totalWeight += cell.n;
        hits.varianceX.push_back(cell.sxx / cell.n - x * x);
        hits.covariance.push_back(cell.sxy / cell.n - x * y);
        hits.varianceY.push_back(cell.syy / cell.n - y * y);
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
    return all;
}

}  // namespace vdamf
