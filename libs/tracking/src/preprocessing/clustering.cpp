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

// Hits in the plane, from the sensor, with the bounds of all.
struct PlaneHits
{
    std::vector<float> x, y;
    std::vector<std::uint32_t> index;  // of the hit in the frame
    std::vector<float> height;
    float minX = kReach, minY = kReach, maxX = -kReach, maxY = -kReach;
};

PlaneHits projectToPlane(const LadarFrame& frame, const AboveGround& above)
{
    const Eigen::Vector3f shift = (frame.origin - frame.sensor).cast<float>();
    PlaneHits hits;
    hits.x.reserve(above.index.size());
    hits.y.reserve(above.index.size());
    hits.index.reserve(above.index.size());
    hits.height.reserve(above.index.size());
    for (std::size_t i = 0; i < above.index.size(); ++i)
    {
        const float x = frame.points.x[above.index[i]] + shift.x();
        const float y = frame.points.y[above.index[i]] + shift.y();
        if (!(std::abs(x) < kReach && std::abs(y) < kReach)) continue;
        hits.x.push_back(x);
        hits.y.push_back(y);
        hits.index.push_back(above.index[i]);
        hits.height.push_back(above.height[i]);
        hits.minX = std::min(hits.minX, x);
        hits.minY = std::min(hits.minY, y);
        hits.maxX = std::max(hits.maxX, x);
        hits.maxY = std::max(hits.maxY, y);
    }
    return hits;
}

// An occupied cell; sums until all hits are in, then means.
struct Cell
{
    float x = 0.0F, y = 0.0F;
    std::uint32_t hits = 0;
    int column = 0, row = 0;
};

struct CellGrid
{
    CellBitmap bitmap;
    std::vector<Cell> cells;              // by number
    std::vector<std::uint32_t> cellOfHit;
};

CellGrid sortIntoCells(const PlaneHits& hits)
{
    const auto toCell = [](float d) { return static_cast<int>(d * (1.0F / kCell)); };
    CellGrid grid{CellBitmap(toCell(hits.maxX - hits.minX) + 1, toCell(hits.maxY - hits.minY) + 1),
                  {},
                  std::vector<std::uint32_t>(hits.x.size())};
    for (std::size_t i = 0; i < hits.x.size(); ++i)
        grid.bitmap.occupy(toCell(hits.x[i] - hits.minX), toCell(hits.y[i] - hits.minY));
    grid.cells.resize(grid.bitmap.enumerate());
    for (std::size_t i = 0; i < hits.x.size(); ++i)
    {
        const int column = toCell(hits.x[i] - hits.minX);
        const int row = toCell(hits.y[i] - hits.minY);
        grid.cellOfHit[i] = grid.bitmap.number(column, row);
        Cell& cell = grid.cells[grid.cellOfHit[i]];
        cell.x += hits.x[i];
        cell.y += hits.y[i];
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
    return static_cast<float>(
        std::min(options.gap + options.gapPerRange * range, options.maxGap));
}

// Unites the cell with those after it, in its row and the rows above, whose means are in reach.
void uniteWithNeighbours(const CellGrid& grid, std::uint32_t number, float gap, DisjointSets& sets)
{
    const Cell& cell = grid.cells[number];
    const int reach = static_cast<int>(gap * (1.0F / kCell)) + 1;
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
            if (dx * dx + dy * dy <= gap * gap) sets.unite(number, n);
        }
    }
}

// Of one group of connected cells.
struct Group
{
    std::uint32_t hits = 0;
    float minX = kReach, minY = kReach, maxX = -kReach, maxY = -kReach;
    std::uint32_t cluster = kNone;

    float extent() const { return std::hypot(maxX - minX, maxY - minY); }
};

std::vector<Cluster> gather(const LadarFrame& frame, const PlaneHits& hits, const CellGrid& grid,
                            DisjointSets& sets, const ClusterOptions& options)
{
    std::vector<std::uint32_t> root(grid.cells.size());
    std::vector<Group> groups(grid.cells.size());
    for (std::uint32_t n = 0; n < grid.cells.size(); ++n)
    {
        const Cell& cell = grid.cells[n];
        root[n] = sets.root(n);
        Group& group = groups[root[n]];
        group.hits += cell.hits;
        group.minX = std::min(group.minX, cell.x);
        group.minY = std::min(group.minY, cell.y);
        group.maxX = std::max(group.maxX, cell.x);
        group.maxY = std::max(group.maxY, cell.y);
    }
    std::vector<Cluster> clusters;
    for (Group& group : groups)
    {
        if (group.hits < static_cast<std::uint32_t>(options.minPoints)) continue;
        if (group.extent() > static_cast<float>(options.maxExtent)) continue;
        group.cluster = static_cast<std::uint32_t>(clusters.size());
        Cluster& cluster = clusters.emplace_back();
        cluster.x.reserve(group.hits);
        cluster.y.reserve(group.hits);
        cluster.z.reserve(group.hits);
        cluster.height.reserve(group.hits);
    }
    for (std::size_t i = 0; i < hits.x.size(); ++i)
    {
        const std::uint32_t to = groups[root[grid.cellOfHit[i]]].cluster;
        if (to == kNone) continue;
        const std::size_t from = hits.index[i];
        clusters[to].x.push_back(frame.points.x[from]);
        clusters[to].y.push_back(frame.points.y[from]);
        clusters[to].z.push_back(frame.points.z[from]);
        clusters[to].height.push_back(hits.height[i]);
    }
    return clusters;
}
}  // namespace

std::vector<Cluster> clusterPoints(const LadarFrame& frame, const AboveGround& aboveGround,
                                   const ClusterOptions& options)
{
    const PlaneHits hits = projectToPlane(frame, aboveGround);
    if (hits.x.empty()) return {};
    const CellGrid grid = sortIntoCells(hits);
    DisjointSets sets(grid.cells.size());
    for (std::uint32_t n = 0; n < grid.cells.size(); ++n)
        uniteWithNeighbours(grid, n, gapAt(grid.cells[n], options), sets);
    return gather(frame, hits, grid, sets, options);
}

}  // namespace vdamf
