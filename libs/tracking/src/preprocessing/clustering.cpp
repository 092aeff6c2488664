// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/clustering.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "preprocessing/disjoint_sets.h"
#include "preprocessing/plane_cells.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
// By cell: how far its cluster goes on from it.
struct Reaches
{
    std::vector<float> squaredGap;  // m^2
    std::vector<std::int32_t> cells;
};

Reaches reachesOf(const PlaneCells& cells, const ClusterOptions& options)
{
    Reaches reaches{std::vector<float>(cells.size()), std::vector<std::int32_t>(cells.size())};
    inWideLanes([
        size = cells.size(), x = cells.x.data(), y = cells.y.data(),
        least = static_cast<float>(options.gap), most = static_cast<float>(options.maxGap),
        perRange = static_cast<float>(options.gapPerRange), squares = reaches.squaredGap.data(),
        counts = reaches.cells.data()
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t i = 0; i < size; ++i)
        {
            const float grown = least + perRange * std::sqrt(x[i] * x[i] + y[i] * y[i]);
            const float gap = grown < most ? grown : most;
            squares[i] = gap * gap;
            counts[i] = static_cast<std::int32_t>(gap * (1.0F / PlaneCells::kSize)) + 1;
        }
    });
    return reaches;
}

typedef std::int32_t Integers __attribute__((vector_size(32)));

// Of eight cells in a row: whether one of the first `count` is within reach of a place, and not
// known to be in the set with that root.
[[gnu::always_inline]] inline bool hasNewNeighbour(const float* x, const float* y,
                                                   const std::uint32_t* parent, int count,
                                                   float atX, float atY, float squaredGap,
                                                   std::uint32_t root)
{
    static_assert(PlaneCells::kPadding >= 8 && DisjointSets::kPadding >= 8);
    Floats dx;
    Floats dy;
    Integers parents;
    load(dx, x);
    load(dy, y);
    load(parents, parent);
    dx -= atX;
    dy -= atY;
    constexpr Integers kNumbers = {0, 1, 2, 3, 4, 5, 6, 7};
    const Integers isNew = (dx * dx + dy * dy <= squaredGap) &
                           (parents != static_cast<std::int32_t>(root)) & (kNumbers < count);
    std::uint64_t any[4];
    std::memcpy(any, &isNew, sizeof any);
    return (any[0] | any[1] | any[2] | any[3]) != 0;
}

// Unites each cell with those after it, in its row and the rows above, whose means are in reach.
[[gnu::always_inline]] inline void uniteNeighbours(const PlaneCells& cells, const Reaches& reaches,
                                                   DisjointSets& sets)
{
    const float* const x = cells.x.data();
    const float* const y = cells.y.data();
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    {
        const float squaredGap = reaches.squaredGap[cell];
        const int reach = reaches.cells[cell];
        const int column = cells.column[cell];
        const int lastRow = std::min(cells.row[cell] + reach, cells.bitmap.rows() - 1);
        std::uint32_t root = sets.root(cell);
        for (int row = cells.row[cell]; row <= lastRow; ++row)
        {
            const int first = row == cells.row[cell] ? column + 1 : column - reach;
            const std::uint64_t bits = cells.bitmap.window(first, row, column + reach - first + 1);
            if (bits == 0) continue;
            // The occupied cells of a window have consecutive numbers.
            std::uint32_t n = cells.bitmap.number(first + __builtin_ctzll(bits), row);
            for (auto left = static_cast<int>(cells.bitmap.population(bits)); left > 0;
                 left -= 8, n += 8)
            {
                // Most cells in reach are in the set already.
                if (!hasNewNeighbour(x + n, y + n, sets.parents() + n, left, x[cell], y[cell],
                                     squaredGap, root))
                    continue;
                for (std::uint32_t k = n; k < n + static_cast<std::uint32_t>(std::min(left, 8));
                     ++k)
                {
                    const float dx = x[k] - x[cell];
                    const float dy = y[k] - y[cell];
                    if (dx * dx + dy * dy <= squaredGap) root = sets.unite(root, k);
                }
            }
        }
    }
}

// Cells that are connected.
struct Group
{
    static constexpr float kFar = 1e9F;
    std::uint32_t hits = 0;
    std::uint32_t cluster = PlaneCells::kNone;
    float minX = kFar, minY = kFar, maxX = -kFar, maxY = -kFar;

    void add(float x, float y, std::uint32_t count)
    {
        hits += count;
        minX = std::min(minX, x);
        minY = std::min(minY, y);
        maxX = std::max(maxX, x);
        maxY = std::max(maxY, y);
    }

    float extent() const { return std::hypot(maxX - minX, maxY - minY); }
};

constexpr std::uint32_t kLoose = 0;  // the number of all groups too small for a cluster

// By cell; all cells of a group have the same number, or PlaneCells::kNone.
struct ClusterOfCell
{
    std::vector<std::uint32_t> cluster;
    std::vector<std::uint32_t> hits{0};  // by number, those of kLoose first
};

ClusterOfCell numberClusters(const PlaneCells& cells, DisjointSets& sets,
                             const ClusterOptions& options)
{
    std::vector<Group> groups(cells.size());
    for (std::uint32_t n = 0; n < cells.size(); ++n)
        groups[sets.root(n)].add(cells.x[n], cells.y[n], cells.hits[n]);
    ClusterOfCell numbers;
    numbers.cluster.reserve(groups.size());
    for (std::uint32_t n = 0; n < groups.size(); ++n)
    {
        const std::uint32_t root = sets.root(n);  // n itself, or a cell before it
        Group& group = groups[root];
        if (root == n && group.hits < static_cast<std::uint32_t>(options.minPoints))
        {
            group.cluster = kLoose;
            numbers.hits[kLoose] += group.hits;
        }
        else if (root == n && group.extent() <= static_cast<float>(options.maxExtent))
        {
            group.cluster = static_cast<std::uint32_t>(numbers.hits.size());
            numbers.hits.push_back(group.hits);
        }
        numbers.cluster.push_back(group.cluster);
    }
    return numbers;
}

// Where the next hit of a cluster goes.
struct Place
{
    float *x, *y, *z, *height;  // of the cluster
    std::size_t next;
};

ClusteredHits gather(const LadarFrame& frame, const AboveGround& above,
                     const std::vector<std::uint32_t>& cellOfHit, const ClusterOfCell& numbers)
{
    std::vector<Cluster> clusters(numbers.hits.size());
    std::vector<Place> places;
    places.reserve(clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i)
    {
        Cluster& c = clusters[i];
        for (auto* values : {&c.x, &c.y, &c.z, &c.height}) values->resize(numbers.hits[i]);
        places.push_back({c.x.data(), c.y.data(), c.z.data(), c.height.data(), 0});
    }
    const bool timed = !frame.points.time.empty();
    const float* const x = frame.points.x.data();
    const float* const y = frame.points.y.data();
    const float* const z = frame.points.z.data();
    for (std::size_t i = 0; i < cellOfHit.size(); ++i)
    {
        if (cellOfHit[i] == PlaneCells::kNone) continue;
        const std::uint32_t to = numbers.cluster[cellOfHit[i]];
        if (to == PlaneCells::kNone) continue;
        const std::size_t from = above.index[i];
        Place& place = places[to];
        const std::size_t next = place.next++;
        place.x[next] = x[from];
        place.y[next] = y[from];
        place.z[next] = z[from];
        place.height[next] = above.height[i];
        if (timed) clusters[to].time.push_back(frame.points.time[from]);
    }
    Cluster loose = std::move(clusters.front());
    clusters.erase(clusters.begin());
    return {std::move(clusters), std::move(loose)};
}
}  // namespace

ClusteredHits clusterHits(const LadarFrame& frame, const AboveGround& aboveGround,
                          const ClusterOptions& options)
{
    const PlaneCells cells = sortIntoCells(frame, aboveGround);
    DisjointSets sets(cells.size());
    const Reaches reaches = reachesOf(cells, options);
    inWideLanes([&]() __attribute__((always_inline)) { uniteNeighbours(cells, reaches, sets); });
    return gather(frame, aboveGround, cells.ofHit, numberClusters(cells, sets, options));
}

std::vector<Cluster> clusterPoints(const LadarFrame& frame, const AboveGround& aboveGround,
                                   const ClusterOptions& options)
{
    return clusterHits(frame, aboveGround, options).clusters;
}

}  // namespace vdamf
