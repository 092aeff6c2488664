// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/hit_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
// Beyond this a cell number would not fit; no sensor reaches there. False for NaN as well.
constexpr float kFarthest = 1e7F;

bool isUsable(float x, float y)
{
    return std::abs(x) < kFarthest && std::abs(y) < kFarthest;
}

// std::floor() calls into the library where the processor's own rounding may not be assumed.
std::int64_t floorOf(double value)
{
    const auto truncated = static_cast<std::int64_t>(value);
    return truncated - (value < static_cast<double>(truncated) ? 1 : 0);
}

// Columns and rows of cells that usable hits lie in.
struct CellRange
{
    std::int64_t firstColumn = 0, firstRow = 0, columns = 0, rows = 0;
};

CellRange rangeOf(const Cluster& cluster, double perMetre)
{
    struct Bounds
    {
        float minX = 1e30F, maxX = -1e30F, minY = 1e30F, maxY = -1e30F;
    } bounds;
    inWideLanes([
        px = cluster.x.data(), py = cluster.y.data(), size = cluster.size(), result = &bounds
    ]() __attribute__((always_inline)) {
        Floats minX = Floats{} + 1e30F, maxX = -minX, minY = minX, maxY = -minX;
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats x, y;
            load(x, px + first, count);
            load(y, py + first, count);
            const auto usable = (x < kFarthest) & (x > -kFarthest) & (y < kFarthest) &
                                (y > -kFarthest) & (kLaneNumbers < static_cast<float>(count));
            minX = usable & (x < minX) ? x : minX;
            maxX = usable & (x > maxX) ? x : maxX;
            minY = usable & (y < minY) ? y : minY;
            maxY = usable & (y > maxY) ? y : maxY;
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        Bounds b;
        for (std::size_t k = 0; k < kLanes<Floats>; ++k)
            b = {std::min(b.minX, minX[k]), std::max(b.maxX, maxX[k]), std::min(b.minY, minY[k]),
                 std::max(b.maxY, maxY[k])};
        *result = b;
    });
    CellRange range;
    if (bounds.minX > bounds.maxX) return range;
    range.firstColumn = floorOf(bounds.minX * perMetre);
    range.firstRow = floorOf(bounds.minY * perMetre);
    range.columns = floorOf(bounds.maxX * perMetre) - range.firstColumn + 1;
    range.rows = floorOf(bounds.maxY * perMetre) - range.firstRow + 1;
    return range;
}

// The cell of a hit by its column and row in a table of all of them: where the hits lie close
// together, which those of a vehicle do, as quick as can be.
class CellTable
{
public:
    CellTable(const CellRange& range, double perMetre)
        : columns_(static_cast<std::int32_t>(range.columns)),
          firstColumn_(static_cast<double>(range.firstColumn)),
          firstRow_(static_cast<double>(range.firstRow)),
          perMetre_(perMetre),
          cells_(static_cast<std::size_t>(range.columns * range.rows), kFree)
    {
    }

    // A cell has a number of 16 bits; and a table of so many fits the second level of caches.
    static bool fits(const CellRange& range)
    {
        constexpr std::int64_t kMost = kFree;
        return range.columns <= kMost && range.rows <= kMost && range.columns * range.rows <= kMost;
    }

    // Places in the table of some hits; -1: not usable.
    void locate(const float* x, const float* y, std::size_t size, std::int32_t* at) const
    {
        inWideLanes([
            =, columns = columns_, firstColumn = firstColumn_, firstRow = firstRow_, perMetre =
            perMetre_
        ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i)
            {
                const bool usable = (std::abs(x[i]) < kFarthest) & (std::abs(y[i]) < kFarthest);
                // Not negative, so that cutting the digits off is rounding down.
                const double column = usable ? x[i] * perMetre - firstColumn : 0.0;
                const double row = usable ? y[i] * perMetre - firstRow : 0.0;
                const std::int32_t place =
                    static_cast<std::int32_t>(row) * columns + static_cast<std::int32_t>(column);
                at[i] = usable ? place : -1;
            }
        });
    }

    // The number of the cell in a place; `next` where it has none yet.
    std::size_t cellAt(std::int32_t place, std::size_t next)
    {
        std::uint16_t& cell = cells_[static_cast<std::size_t>(place)];
        if (cell == kFree) cell = static_cast<std::uint16_t>(next);
        return cell;
    }

private:
    static constexpr std::uint16_t kFree = 0xffff;
    std::int32_t columns_;
    double firstColumn_;
    double firstRow_;
    double perMetre_;
    std::vector<std::uint16_t> cells_;
};

// The same for hits that lie far apart: open addressing, one look a hit however large the cluster
// is.
class CellFinder
{
public:
    explicit CellFinder(double perMetre) : perMetre_(perMetre), slots_(256) {}

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

float heightAt(const Cluster& cluster, std::size_t i)
{
    return cluster.height.empty() ? 0.0F : cluster.height[i];
}

// By their first hits.
template <class Finder>
std::vector<HitCell> cellsOf(const Cluster& cluster, Finder&& finder, std::size_t expected)
{
    std::vector<HitCell> cells;
    cells.reserve(expected);
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const float x = cluster.x[i];
        const float y = cluster.y[i];
        if (!isUsable(x, y)) continue;
        const std::size_t cell = finder.find(x, y, cells.size());
        if (cell == cells.size()) cells.push_back({x, y});
        cells[cell].add(x, y, heightAt(cluster, i));
    }
    return cells;
}

std::vector<HitCell> cellsIn(const Cluster& cluster, CellTable table, std::size_t expected)
{
    std::vector<HitCell> cells;
    cells.reserve(expected);
    std::array<std::int32_t, 512> place;
    for (std::size_t begin = 0; begin < cluster.size(); begin += place.size())
    {
        const float* const x = cluster.x.data() + begin;
        const float* const y = cluster.y.data() + begin;
        const std::size_t size = std::min(place.size(), cluster.size() - begin);
        table.locate(x, y, size, place.data());
        for (std::size_t i = 0; i < size; ++i)
        {
            if (place[i] < 0) continue;
            const std::size_t cell = table.cellAt(place[i], cells.size());
            if (cell == cells.size()) cells.push_back({x[i], y[i]});
            cells[cell].add(x[i], y[i], heightAt(cluster, begin + i));
        }
    }
    return cells;
}

// Every hit alone.
struct NoCells
{
    static std::size_t find(float, float, std::size_t next) { return next; }
};

}  // namespace

std::vector<HitCell> hitCells(const Cluster& cluster, double size)
{
    if (size <= 0.0) return cellsOf(cluster, NoCells(), cluster.size());
    constexpr std::size_t kExpected = 128;
    const std::size_t expected = std::min(kExpected, cluster.size());
    const double perMetre = 1.0 / size;
    const CellRange range = rangeOf(cluster, perMetre);
    if (CellTable::fits(range)) return cellsIn(cluster, CellTable(range, perMetre), expected);
    return cellsOf(cluster, CellFinder(perMetre), expected);
}

}  // namespace vdamf
