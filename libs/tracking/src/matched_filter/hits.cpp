// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/hits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

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

// The part of the plane that the hits of a cluster lie in, those that are not numbers left out.
struct Bounds
{
    float minX = 1e30F, minY = 1e30F, maxX = -1e30F, maxY = -1e30F;

    explicit Bounds(const Cluster& cluster)
    {
        for (const float x : cluster.x)
        {
            minX = x < minX ? x : minX;
            maxX = x > maxX ? x : maxX;
        }
        for (const float y : cluster.y)
        {
            minY = y < minY ? y : minY;
            maxY = y > maxY ? y : maxY;
        }
    }
};

// Finds the cell of a hit in a table of all cells within bounds: for clusters that fill a good part
// of theirs the fastest way.
class CellTable
{
public:
    CellTable(const Bounds& bounds, double cellSize)
        : perMetre_(1.0 / cellSize),
          firstColumn_(static_cast<double>(floorOf(bounds.minX * perMetre_))),
          firstRow_(static_cast<double>(floorOf(bounds.minY * perMetre_))),
          columns_(static_cast<std::size_t>(bounds.maxX * perMetre_ - firstColumn_) + 1),
          cells_(columns_ * (static_cast<std::size_t>(bounds.maxY * perMetre_ - firstRow_) + 1),
                 kFree)
    {
    }

    std::size_t find(float x, float y, std::size_t next)
    {
        const auto column =
            static_cast<std::size_t>(static_cast<std::int64_t>(x * perMetre_ - firstColumn_));
        const auto row =
            static_cast<std::size_t>(static_cast<std::int64_t>(y * perMetre_ - firstRow_));
        std::uint32_t& cell = cells_[row * columns_ + column];
        cell = cell == kFree ? static_cast<std::uint32_t>(next) : cell;
        return cell;
    }

private:
    static constexpr std::uint32_t kFree = static_cast<std::uint32_t>(-1);

    double perMetre_;
    double firstColumn_, firstRow_;
    std::size_t columns_;
    std::vector<std::uint32_t> cells_;
};

template <class Finder>
std::vector<Cell> cellsBy(const Cluster& cluster, Finder finder)
{
    std::vector<Cell> cells;
    cells.reserve(std::min<std::size_t>(cluster.size(), 256));
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const float x = cluster.x[i];
        const float y = cluster.y[i];
        if (!isUsable(x, y)) continue;
        const std::size_t cell = finder.find(x, y, cells.size());
        if (cell == cells.size()) cells.push_back({x, y});
        cells[cell].add(x, y);
    }
    return cells;
}

// Every hit is a cell of its own.
struct NoFinder
{
    std::size_t find(float, float, std::size_t next) const { return next; }
};

// By their first hits; cellSize 0: a cell of its own for each.
std::vector<Cell> cellsOf(const Cluster& cluster, double cellSize)
{
    if (cellSize <= 0.0) return cellsBy(cluster, NoFinder());
    const Bounds bounds(cluster);
    if (bounds.minX > bounds.maxX || bounds.minY > bounds.maxY) return {};
    const double area = (static_cast<double>(bounds.maxX) - bounds.minX + cellSize) *
                        (static_cast<double>(bounds.maxY) - bounds.minY + cellSize);
    const double mostCells = 1000.0 + 40.0 * static_cast<double>(cluster.size());
    if (area < mostCells * cellSize * cellSize)
        return cellsBy(cluster, CellTable(bounds, cellSize));
    return cellsBy(cluster, CellFinder(cellSize));
}
}  // namespace

double lowerBodyShare(const Hits& hits)
{
    // Nothing but zeros: of points without height.
    if (hits.heights <= 1) return 1.0;
    constexpr unsigned kFirst = 3;
    constexpr unsigned kLast = 9;
    unsigned seen = 0;
    for (unsigned k = kFirst; k <= kLast; ++k) seen += (hits.heights >> k) & 1U;
    return seen / (kLast - kFirst + 1.0);
}

Hits projectHits(const Cluster& cluster, double cellSize)
{
    Hits hits;
    const std::vector<Cell> cells = cellsOf(cluster, cellSize);
    hits.heights = heightsOf(cluster);
    if (!cluster.time.empty())
        hits.time = std::accumulate(cluster.time.begin(), cluster.time.end(), 0.0) /
                    static_cast<double>(cluster.time.size());
    for (auto* column :
         {&hits.x, &hits.y, &hits.weight, &hits.varianceX, &hits.covariance, &hits.varianceY})
        column->resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
        const Cell& cell = cells[i];
        const double share = 1.0 / cell.n;
        const double x = cell.sx * share;
        const double y = cell.sy * share;
        hits.x[i] = cell.x + x;
        hits.y[i] = cell.y + y;
        hits.weight[i] = cell.n;
        hits.totalWeight += cell.n;
        hits.varianceX[i] = cell.sxx * share - x * x;
        hits.covariance[i] = cell.sxy * share - x * y;
        hits.varianceY[i] = cell.syy * share - y * y;
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
    return all;
}

}  // namespace vdamf
