// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/discrimination/features.h"

#include <cmath>
#include <cstdint>

#include "discrimination/descriptors.h"
#include "discrimination/pair_features.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
/// Finds cells along an axis without a division for each hit.
struct AxisCells
{
    explicit AxisCells(const GridAxis& axis)
        : min(static_cast<float>(axis.min)),
          perMetre(static_cast<float>(1.0 / axis.cellSize())),
          cells(static_cast<float>(axis.cells))
    {
    }
    [[gnu::always_inline]] float at(float value) const { return (value - min) * perMetre; }
    [[gnu::always_inline]] bool has(float cell) const { return (cell >= 0.0F) & (cell < cells); }

    float min;
    float perMetre;
    float cells;
};

// The cell of the grid that each hit is in; -1: none.
std::vector<std::int32_t> gridCells(const CanonicalHits& hits, const DiscriminationGrid& grid)
{
    std::vector<std::int32_t> cells(hits.size());
    inWideLanes([
        alongX = AxisCells(grid.x), alongY = AxisCells(grid.y), alongZ = AxisCells(grid.z),
        nx = grid.x.cells, ny = grid.y.cells, x = hits.x.data(), y = hits.y.data(),
        z = hits.z.data(), size = hits.size(), to = cells.data()
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t n = 0; n < size; ++n)
        {
            const float i = alongX.at(x[n]);
            const float j = alongY.at(y[n]);
            const float k = alongZ.at(z[n]);
            const bool inside = alongX.has(i) & alongY.has(j) & alongZ.has(k);
            // As DiscriminationGrid::index().
            const auto row = static_cast<std::int32_t>(inside ? j : 0.0F) +
                             ny * static_cast<std::int32_t>(inside ? k : 0.0F);
            to[n] = inside ? static_cast<std::int32_t>(i) + nx * row : -1;
        }
    });
    return cells;
}

struct CellValue
{
    std::size_t cell = 0;
    float value = 0.0F;
};

// Those with hits.
std::vector<CellValue> cellsOf(const CanonicalHits& hits, const DiscriminationGrid& grid)
{
    std::vector<float> counts(grid.cells(), 0.0F);
    std::vector<CellValue> cells;
    for (const std::int32_t each : gridCells(hits, grid))
    {
        if (each < 0) continue;
        const auto cell = static_cast<std::size_t>(each);
        if (counts[cell] == 0.0F) cells.push_back({cell, 0.0F});
        counts[cell] += 1.0F;
    }
    const float share = 1.0F / static_cast<float>(hits.size());
    for (CellValue& each : cells) each.value = std::sqrt(counts[each.cell] * share);
    return cells;
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
    if (!view.planar)
        for (const CellValue& each : cellsOf(hits, grid)) features[each.cell] = each.value;
    putPairs(describe(hits, view), view.planar, features.data() + grid.cells());
    return features;
}

double objectScore(const ObjectView& view, const DiscriminatorModel& model)
{
    const CanonicalHits hits = toCanonicalFrame(view);
    if (hits.size() == 0) return model.bias;
    double score = model.bias;
    if (!view.planar)
        for (const CellValue& each : cellsOf(hits, model.grid))
            score += model.weights[each.cell] * static_cast<double>(each.value);
    return score +
           pairScore(describe(hits, view), view.planar, model.weights.data() + model.grid.cells());
}

}  // namespace vdamf
