// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/clustering.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "preprocessing/cell_bitmap.h"
#include "preprocessing/disjoint_sets.h"

namespace vdamf
{
namespace
{
constexpr float kCell = 0.2F;      // m
constexpr float kReach = 1000.0F;  // hits farther than this from the sensor are no use, m
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// The hits in the plane, from the sensor: with one pass for each use less memory is touched than
// with a copy.
class PlaneView
{
public:
    PlaneView(const LadarFrame& frame, const AboveGround& above)
        : points_(frame.points),
          index_(above.index),
          shift_((frame.origin - frame.sensor).head<2>().cast<float>())
    {
    }

    std::size_t size() const { return index_.size(); }
    float x(std::size_t i) const { return points_.x[index_[i]] + shift_.x(); }
    float y(std::size_t i) const { return points_.y[index_[i]] + shift_.y(); }
    bool used(std::size_t i) const { return (std::abs(x(i)) < kReach) & (std::abs(y(i)) < kReach); }

private:
    const PointCloud& points_;
    const std::vector<std::uint32_t>& index_;
    Eigen::Vector2f shift_;
};

struct Bounds
{
    float minX = kReach, minY = kReach, maxX = -kReach, maxY = -kReach;

    void add(float x, float y)
    {
        minX = std::min(minX, x);
        minY = std::min(minY, y);
        maxX = std::max(maxX, x);
        maxY = std::max(maxY, y);
    }
};

Bounds boundsOf(const PlaneView& hits)
{
    Bounds bounds;
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (hits.used(i)) bounds.add(hits.x(i), hits.y(i));
    return bounds;
}

// An occupied cell; sums until all hits are in, then means.
struct Cell
{
    float x = 0.0F, y = 0.0F;
    std::uint32_t hits = 0;
    std::uint16_t column = 0, row = 0;
};

struct CellGrid
{
    CellBitmap bitmap;
    std::vector<Cell> cells;               // by number
    std::vector<std::uint32_t> cellOfHit;  // kNone: hit not used
};

int cellsIn(float distance)
{
    return static_cast<int>(distance * (1.0F / kCell));
}

// Row and column of each hit, packed; kNone where it is not used.
std::vector<std::uint32_t> occupyCells(const PlaneView& hits, const Bounds& bounds,
                                       CellBitmap& bitmap)
{
    std::vector<std::uint32_t> packed(hits.size(), kNone);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        if (!hits.used(i)) continue;
        const int column = cellsIn(hits.x(i) - bounds.minX);
        const int row = cellsIn(hits.y(i) - bounds.minY);
        bitmap.occupy(column, row);
        packed[i] = static_cast<std::uint32_t>(row << 16 | column);
    }
    return packed;
}

CellGrid sortIntoCells(const PlaneView& hits)
{
    const Bounds b = boundsOf(hits);
    if (b.minX > b.maxX) return {CellBitmap(0, 0), {}, {}};
    CellGrid grid{CellBitmap(cellsIn(b.maxX - b.minX) + 1, cellsIn(b.maxY - b.minY) + 1), {}, {}};
    grid.cellOfHit = occupyCells(hits, b, grid.bitmap);
    grid.cells.resize(grid.bitmap.enumerate());
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const std::uint32_t packed = grid.cellOfHit[i];
        if (packed == kNone) continue;
        const auto column = static_cast<std::uint16_t>(packed & 0xFFFFU);
        const auto row = static_cast<std::uint16_t>(packed >> 16);
        grid.cellOfHit[i] = grid.bitmap.number(column, row);
        Cell& cell = grid.cells[grid.cellOfHit[i]];
        cell.x += hits.x(i);
        cell.y += hits.y(i);
        ++cell.hits;
        cell.column = column;
        cell.row = row;
    }
    for (Cell& cell : grid.cells)
    {
        cell.x /= static_cast<float>(cell.hits);
        cell.y /= static_cast<float>(cell.hits);
    }
    return grid;
}

float gapAt(const Cell& cell, const ClusterOptions& options)
{
    const double range = std::sqrt(static_cast<double>(cell.x * cell.x + cell.y * cell.y));
    return static_cast<float>(std::min(options.gap + options.gapPerRange * range, options.maxGap));
}

// Unites the cell with those after it, in its row and the rows above, whose means are in reach.
void uniteWithNeighbours(const CellGrid& grid, std::uint32_t number, float gap, DisjointSets& sets)
{
    const Cell& cell = grid.cells[number];
    const int reach = static_cast<int>(gap * (1.0F / kCell)) + 1;
    std::uint32_t root = sets.root(number);
    const int lastRow = std::min(cell.row + reach, grid.bitmap.rows() - 1);
    for (int row = cell.row; row <= lastRow; ++row)
    {
        const int first = row == cell.row ? cell.column + 1 : cell.column - reach;
        const int width = cell.column + reach - first + 1;
        std::uint64_t bits = grid.bitmap.window(first, row, width);
        if (bits == 0) continue;
        // The occupied cells of a window have consecutive numbers.
        const int skipped = __builtin_ctzll(bits);
        for (std::uint32_t n = grid.bitmap.number(first + skipped, row); bits != 0;
             bits &= bits - 1, ++n)
        {
            const float dx = grid.cells[n].x - cell.x;
            const float dy = grid.cells[n].y - cell.y;
            if (dx * dx + dy * dy <= gap * gap) root = sets.unite(root, n);
        }
    }
}

// Cells that are connected.
struct Group
{
    std::uint32_t hits = 0;
    std::uint32_t cluster = kNone;
    Bounds bounds;

    float extent() const
    {
        return std::hypot(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY);
    }
};

// By cell; all cells of a group name the same cluster, or kNone.
struct ClusterOfCell
{
    std::vector<std::uint32_t> cluster;
    std::vector<std::uint32_t> hits;  // by cluster
};

ClusterOfCell numberClusters(const CellGrid& grid, DisjointSets& sets,
                             const ClusterOptions& options)
{
    std::vector<Group> groups(grid.cells.size());
    for (std::uint32_t n = 0; n < grid.cells.size(); ++n)
    {
        Group& group = groups[sets.root(n)];
        group.hits += grid.cells[n].hits;
        group.bounds.add(grid.cells[n].x, grid.cells[n].y);
    }
    ClusterOfCell numbers;
    numbers.cluster.reserve(groups.size());
    for (std::uint32_t n = 0; n < groups.size(); ++n)
    {
        const std::uint32_t root = sets.root(n);  // n itself, or a cell before it
        Group& group = groups[root];
        if (root == n && group.hits >= static_cast<std::uint32_t>(options.minPoints) &&
            group.extent() <= static_cast<float>(options.maxExtent))
        {
            group.cluster = static_cast<std::uint32_t>(numbers.hits.size());
            numbers.hits.push_back(group.hits);
        }
        numbers.cluster.push_back(group.cluster);
    }
    return numbers;
}

std::vector<Cluster> gather(const LadarFrame& frame, const AboveGround& above,
                            const std::vector<std::uint32_t>& cellOfHit,
                            const ClusterOfCell& numbers)
{
    std::vector<Cluster> clusters(numbers.hits.size());
    for (std::size_t i = 0; i < clusters.size(); ++i)
        for (auto* values : {&clusters[i].x, &clusters[i].y, &clusters[i].z, &clusters[i].height})
            values->reserve(numbers.hits[i]);
    const bool timed = !frame.points.time.empty();
    for (std::size_t i = 0; i < cellOfHit.size(); ++i)
    {
        if (cellOfHit[i] == kNone) continue;
        const std::uint32_t to = numbers.cluster[cellOfHit[i]];
        if (to == kNone) continue;
        const std::size_t from = above.index[i];
        clusters[to].x.push_back(frame.points.x[from]);
        clusters[to].y.push_back(frame.points.y[from]);
        clusters[to].z.push_back(frame.points.z[from]);
        clusters[to].height.push_back(above.height[i]);
        if (timed) clusters[to].time.push_back(frame.points.time[from]);
    }
    return clusters;
}
}  // namespace

std::vector<Cluster> clusterPoints(const LadarFrame& frame, const AboveGround& aboveGround,
                                   const ClusterOptions& options)
{
    const CellGrid grid = sortIntoCells(PlaneView(frame, aboveGround));
    DisjointSets sets(grid.cells.size());
    for (std::uint32_t n = 0; n < grid.cells.size(); ++n)
        uniteWithNeighbours(grid, n, gapAt(grid.cells[n], options), sets);
    return gather(frame, aboveGround, grid.cellOfHit, numberClusters(grid, sets, options));
}

}  // namespace vdamf
