// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/discrimination/features.h"

#include <cmath>

#include "discrimination/descriptors.h"
#include "discrimination/pair_features.h"

namespace vdamf
{
namespace
{
/// Finds cells along an axis without a division for each hit.
struct CellFinder
{
    explicit CellFinder(const GridAxis& axis)
        : min(static_cast<float>(axis.min)),
          perMetre(static_cast<float>(1.0 / axis.cellSize())),
          cells(axis.cells)
    {
    }
    /// -1: outside.
    int at(float value) const
    {
        const float cell = (value - min) * perMetre;
        return cell >= 0.0F && cell < static_cast<float>(cells) ? static_cast<int>(cell) : -1;
    }

    float min;
    float perMetre;
    int cells;
};

void putCells(const CanonicalHits& hits, const DiscriminationGrid& grid, float* cells)
{
    const CellFinder x(grid.x);
    const CellFinder y(grid.y);
    const CellFinder z(grid.z);
    for (std::size_t n = 0; n < hits.size(); ++n)
    {
        const int i = x.at(hits.x[n]);
        const int j = y.at(hits.y[n]);
        const int k = z.at(hits.z[n]);
        if (i >= 0 && j >= 0 && k >= 0) cells[grid.index(i, j, k)] += 1.0F;
    }
    const float share = 1.0F / static_cast<float>(hits.size());
    for (std::size_t c = 0; c < grid.cells(); ++c) cells[c] = std::sqrt(cells[c] * share);
}
}  // namespace

std::vector<FeatureBlock> featureBlocks(const DiscriminationGrid& grid)
{
    std::vector<FeatureBlock> blocks = {{"cells", 0, grid.cells()}};
    for (const PairBlock& pair : pairBlocks())
        blocks.push_back({pair.name, blocks.back().first + blocks.back().size, pair.size});
    return blocks;
}

std::size_t featureCount(const DiscriminationGrid& grid)
{
    return grid.cells() + pairFeatureCount();
}

std::vector<float> objectFeatures(const ObjectView& view, const DiscriminationGrid& grid)
{
    std::vector<float> features(featureCount(grid), 0.0F);
    const CanonicalHits hits = toCanonicalFrame(view);
    if (hits.size() == 0) return features;
    if (!view.planar) putCells(hits, grid, features.data());
    putPairs(describe(hits, view), view.planar, features.data() + grid.cells());
    return features;
}

}  // namespace vdamf
