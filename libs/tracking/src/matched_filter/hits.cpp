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

// Finds the cell of a hit by its column and row: open addressing, so that the cost is one look a
// hit however large the cluster is.
class CellFinder
{
public:
    CellFinder(std::size_t hits, double cellSize) : perMetre_(1.0 / cellSize)
    {
        std::size_t slots = 64;
        while (slots < 2 * hits) slots *= 2;
        slots_.assign(slots, Slot{0, kFree});
    }

    // The number of the hit's cell; `next` where it is the first hit of a new one.
    std::size_t find(float x, float y, std::size_t next)
    {
        const auto column = static_cast<std::int64_t>(std::floor(x * perMetre_));
        const auto row = static_cast<std::int64_t>(std::floor(y * perMetre_));
        const std::int64_t key = row * (std::int64_t{1} << 32) + column;
        const std::size_t mask = slots_.size() - 1;
        auto at = static_cast<std::size_t>(column + row * 0x9e3779b1) & mask;
        while (slots_[at].cell != kFree && slots_[at].key != key) at = (at + 1) & mask;
        if (slots_[at].cell == kFree) slots_[at] = {key, next};
        return slots_[at].cell;
    }

private:
    static constexpr std::size_t kFree = static_cast<std::size_t>(-1);
    struct Slot
    {
        std::int64_t key;
        std::size_t cell;
    };
    double perMetre_;
    std::vector<Slot> slots_;
};

// By their first hits; cellSize 0: a cell of its own for each.
std::vector<Cell> cellsOf(const Cluster& cluster, double cellSize)
{
    std::vector<Cell> cells;
    cells.reserve(cluster.size());
    std::optional<CellFinder> finder;
    if (cellSize > 0.0) finder.emplace(cluster.size(), cellSize);
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
