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

struct CellValue
{
    std::size_t cell = 0;
    float value = 0.0F;
};

// Those with hits.
std::vector<CellValue> cellsOf(const CanonicalHits& hits, const DiscriminationGrid& grid)
{
    const CellFinder x(grid.x);
    const CellFinder y(grid.y);
    const CellFinder z(grid.z);
    std::vector<float> counts(grid.cells(), 0.0F);
    std::vector<CellValue> cells;
    for (std::size_t n = 0; n < hits.size(); ++n)
    {
        const int i = x.at(hits.x[n]);
        const int j = y.at(hits.y[n]);
        const int k = z.at(hits.z[n]);
        if (i < 0 || j < 0 || k < 0) continue;
        const std::size_t cell = grid.index(i, j, k);
        if (counts[cell] == 0.0F) cells.push_back({cell, 0.0F});
        counts[cell] += 1.0F;
    }
    const float share = 1.0F / static_cast<float>(hits.size());
    for (CellValue& each : cells) each.value = std::sqrt(counts[each.cell] * share);
    return cells;
}

// The features that are not zero.
struct SparseFeatures
{
    std::vector<CellValue> cells;
    std::vector<PairValue> pairs;
};

SparseFeatures sparseFeatures(const ObjectView& view, const DiscriminationGrid& grid)
{
    SparseFeatures features;
    const CanonicalHits hits = toCanonicalFrame(view);
    if (hits.size() == 0) return features;
    if (!view.planar) features.cells = cellsOf(hits, grid);
    features.pairs = pairsOf(describe(hits, view), view.planar);
    return features;
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
    const SparseFeatures sparse = sparseFeatures(view, grid);
    std::vector<float> features(featureCount(grid), 0.0F);
    for (const CellValue& each : sparse.cells) features[each.cell] = each.value;
    for (const PairValue& pair : sparse.pairs)
        for (std::size_t k = 0; k < 4; ++k)
            features[grid.cells() + pair.feature(k)] += pair.value[k];
    return features;
}

double objectScore(const ObjectView& view, const DiscriminatorModel& model)
{
    const SparseFeatures sparse = sparseFeatures(view, model.grid);
    double score = model.bias;
    for (const CellValue& each : sparse.cells)
        score += model.weights[each.cell] * static_cast<double>(each.value);
    const double* const weights = model.weights.data() + model.grid.cells();
    for (const PairValue& pair : sparse.pairs)
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
            sum += weights[pair.feature(k)] * static_cast<double>(pair.value[k]);
        score += sum;
    }
    return score;
}

}  // namespace vdamf
