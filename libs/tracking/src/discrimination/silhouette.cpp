// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/silhouette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vdamf
{
namespace
{
constexpr float kCell = 0.25F;  // m, wider than the distance of two rays at usual ranges
constexpr std::size_t kRasterColumns = 128;
constexpr std::size_t kRasterRows = 12;

/// Depths of the hits in one cell.
struct Cell
{
    float count = 0.0F;
    float sum = 0.0F;
    float squares = 0.0F;

    bool hasHits() const { return count > 0.0F; }
    float mean() const { return sum / count; }
    float scatter() const { return std::sqrt(std::max(0.0F, squares / count - mean() * mean())); }
};

/// Mean of numbers, nothing without any.
struct Mean
{
    double sum = 0.0;
    double weight = 0.0;

    void add(double value, double w = 1.0)
    {
        sum += w * value;
        weight += w;
    }
    std::optional<double> get() const
    {
        if (weight == 0.0) return std::nullopt;
        return sum / weight;
    }
};

struct Raster
{
    float breadth = 0.0F;     ///< m
    std::size_t columns = 0;  ///< that are in use
    std::vector<Cell> cells;  ///< rows of a column run fastest
    std::vector<float> top;   ///< highest hit of each column, m; below all hits: none

    static constexpr float kNone = -1e9F;

    bool hasHits(std::size_t column) const { return top[column] > kNone; }
    const Cell& at(std::size_t column, std::size_t row) const
    {
        return cells[column * kRasterRows + row];
    }
};

Raster rasterOf(const CanonicalHits& hits, bool planar)
{
    const Eigen::Vector2f away = -hits.sensor.cast<float>().normalized();
    std::vector<float> across;
    across.reserve(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
        across.push_back(away.x() * hits.y[i] - away.y() * hits.x[i]);
    const auto [min, max] = std::minmax_element(across.begin(), across.end());
    const float first = *min;
    const auto columnOf = [&](float value)
    {
        return static_cast<std::size_t>(
            std::min(static_cast<float>(kRasterColumns - 1), (value - first) / kCell));
    };
    Raster raster;
    raster.breadth = *max - first;
    raster.columns = 1 + columnOf(*max);
    raster.cells.resize(raster.columns * kRasterRows);
    raster.top.assign(raster.columns, Raster::kNone);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const std::size_t column = columnOf(across[i]);
        const float row =
            planar ? 0.0F
                   : std::clamp(hits.z[i] / kCell, 0.0F, static_cast<float>(kRasterRows - 1));
        Cell& cell = raster.cells[column * kRasterRows + static_cast<std::size_t>(row)];
        const float depth = away.x() * hits.x[i] + away.y() * hits.y[i];
        cell.count += 1.0F;
        cell.sum += depth;
        cell.squares += depth * depth;
        raster.top[column] = std::max(raster.top[column], hits.z[i]);
    }
    return raster;
}

/// Mean second difference of the tops of the columns that have hits.
std::optional<double> raggedOf(const Raster& raster)
{
    std::vector<float> tops;
    std::copy_if(raster.top.begin(), raster.top.end(), std::back_inserter(tops),
                 [](float top) { return top > Raster::kNone; });
    Mean mean;
    for (std::size_t i = 1; i + 1 < tops.size(); ++i)
        mean.add(static_cast<double>(std::abs(tops[i - 1] - 2.0F * tops[i] + tops[i + 1])));
    return mean.get();
}

/// Adds what the cells of a column tell.
void addColumn(const Raster& raster, std::size_t column, Mean& thickness, Mean& bend, Mean& slope)
{
    constexpr float kMost = 1.0F;  // m, so that what stands behind does not outweigh all
    for (std::size_t row = 0; row < kRasterRows; ++row)
    {
        const Cell& cell = raster.at(column, row);
        if (!cell.hasHits()) continue;
        if (cell.count > 1.0F)
            thickness.add(static_cast<double>(std::min(kMost, cell.scatter())),
                          static_cast<double>(cell.count));
        if (column + 1 < raster.columns && raster.at(column + 1, row).hasHits())
            bend.add(static_cast<double>(
                std::min(kMost, std::abs(raster.at(column + 1, row).mean() - cell.mean()))));
        if (row + 1 < kRasterRows && raster.at(column, row + 1).hasHits())
            slope.add(static_cast<double>(
                std::clamp(raster.at(column, row + 1).mean() - cell.mean(), -kMost, kMost)));
    }
}
}  // namespace

Silhouette silhouetteOf(const CanonicalHits& hits, bool planar)
{
    const Raster raster = rasterOf(hits, planar);
    Mean thickness;
    Mean bend;
    Mean slope;
    std::size_t covered = 0;
    for (std::size_t column = 0; column < raster.columns; ++column)
    {
        if (!raster.hasHits(column)) continue;
        ++covered;
        addColumn(raster, column, thickness, bend, slope);
    }
    Silhouette s;
    s.breadth = static_cast<double>(raster.breadth);
    s.coverage = static_cast<double>(covered) / static_cast<double>(raster.columns);
    s.thickness = thickness.get();
    s.bend = bend.get();
    if (planar) return s;
    s.slope = slope.get();
    s.ragged = raggedOf(raster);
    return s;
}

}  // namespace vdamf
