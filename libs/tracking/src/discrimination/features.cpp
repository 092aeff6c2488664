// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/discrimination/features.h"

#include <cmath>

#include "discrimination/descriptors.h"
#include "discrimination/knots.h"

namespace vdamf
{
namespace
{
constexpr double kLength[] = {0.3, 0.8, 1.3, 1.8, 2.5, 3.5, 4.3, 5.2, 7.0, 11.0, 18.0};
constexpr double kWidth[] = {0.2, 0.6, 1.0, 1.4, 1.8, 2.4, 3.5};
constexpr double kTop[] = {0.5, 0.9, 1.25, 1.5, 1.8, 2.2, 2.7, 3.0};
constexpr double kBottom[] = {0.22, 0.4, 0.7, 1.1, 1.6};
constexpr double kDepth[] = {0.02, 0.06, 0.12, 0.2, 0.3, 0.5, 0.8};
constexpr double kShare[] = {0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0};
constexpr double kScatter[] = {0.01, 0.03, 0.06, 0.1, 0.16, 0.25, 0.4};
constexpr double kMatch[] = {-0.5, 0.0, 0.3, 0.6, 0.9, 1.2, 1.5};
constexpr double kDensity[] = {-4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0};
constexpr double kBreadth[] = {0.4, 1.0, 1.6, 2.2, 3.5, 5.0, 9.0};
constexpr double kCovered[] = {0.3, 0.5, 0.7, 0.85, 1.0};
constexpr double kHighShare[] = {0.0, 0.03, 0.1, 0.25, 0.5, 0.8};
constexpr double kTopOfHigh[] = {1.8, 2.2, 2.6, 2.9, 3.0};
constexpr double kBearing[] = {0.0, 0.15, 0.4, 0.8, 1.2, 1.42, 1.57};

struct BlockShape
{
    const char* name;
    Knots first;
    Knots second{nullptr, 1};  // of the product with a second and a third number
    Knots third{nullptr, 1};

    std::size_t size() const { return first.count * second.count * third.count; }
};

// Order of `blocks` below. Flat sizes serve planar scans, which know no heights.
enum Block : std::size_t
{
    kSize,
    kFlatSize,
    kBottomBlock,
    kOutside,
    kDepthBlock,
    kNear,
    kStraightness,
    kOnSide,
    kMatchBlock,
    kDensityBlock,
    kBearingBlock,
    kCoverage,
    kHigh,
    kSurface,
    kBlocks
};

const BlockShape kShapes[kBlocks] = {{"size", knotsOf(kLength), knotsOf(kWidth), knotsOf(kTop)},
                                     {"flat_size", knotsOf(kLength), knotsOf(kWidth)},
                                     {"bottom", knotsOf(kBottom)},
                                     {"outside", knotsOf(kShare)},
                                     {"depth", knotsOf(kDepth)},
                                     {"near", knotsOf(kShare)},
                                     {"straightness", knotsOf(kScatter)},
                                     {"on_side", knotsOf(kShare)},
                                     {"match", knotsOf(kMatch)},
                                     {"density", knotsOf(kDensity)},
                                     {"bearing", knotsOf(kBearing)},
                                     {"coverage", knotsOf(kBreadth), knotsOf(kCovered)},
                                     {"high", knotsOf(kHighShare), knotsOf(kTopOfHigh)},
                                     {"surface", knotsOf(kScatter), knotsOf(kDepth)}};

/// Writes descriptors behind the cells.
class DescriptorWriter
{
public:
    explicit DescriptorWriter(float* features)
    {
        for (std::size_t b = 0; b < kBlocks; ++b)
        {
            blocks_[b] = features;
            features += kShapes[b].size();
        }
    }

    void put(Block block, double value)
    {
        const KnotPlace at = placeOf(kShapes[block].first, value);
        blocks_[block][at.below] = static_cast<float>(1.0 - at.shareAbove);
        blocks_[block][at.below + 1] = static_cast<float>(at.shareAbove);
    }

    void put(Block block, double a, double b)
    {
        const BlockShape& shape = kShapes[block];
        addPlane(blocks_[block], shape, placeOf(shape.first, a), placeOf(shape.second, b), 1.0);
    }

    void put(Block block, double a, double b, double c)
    {
        const BlockShape& shape = kShapes[block];
        const KnotPlace at = placeOf(shape.third, c);
        float* const plane = blocks_[block] + at.below * shape.first.count * shape.second.count;
        const KnotPlace first = placeOf(shape.first, a);
        const KnotPlace second = placeOf(shape.second, b);
        addPlane(plane, shape, first, second, 1.0 - at.shareAbove);
        addPlane(plane + shape.first.count * shape.second.count, shape, first, second,
                 at.shareAbove);
    }

private:
    static void addPlane(float* plane, const BlockShape& shape, const KnotPlace& a,
                         const KnotPlace& b, double share)
    {
        for (std::size_t j = 0; j < 2; ++j)
        {
            const double part = share * (j == 0 ? 1.0 - b.shareAbove : b.shareAbove);
            float* const row = plane + (b.below + j) * shape.first.count + a.below;
            row[0] += static_cast<float>(part * (1.0 - a.shareAbove));
            row[1] += static_cast<float>(part * a.shareAbove);
        }
    }

    float* blocks_[kBlocks] = {};
};

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
    for (const BlockShape& shape : kShapes)
        blocks.push_back({shape.name, blocks.back().first + blocks.back().size, shape.size()});
    return blocks;
}

std::size_t featureCount(const DiscriminationGrid& grid)
{
    std::size_t count = grid.cells();
    for (const BlockShape& shape : kShapes) count += shape.size();
    return count;
}

std::vector<float> objectFeatures(const ObjectView& view, const DiscriminationGrid& grid)
{
    std::vector<float> features(featureCount(grid), 0.0F);
    const CanonicalHits hits = toCanonicalFrame(view);
    if (hits.size() == 0) return features;
    const Descriptors d = describe(hits, view);
    DescriptorWriter writer(features.data() + grid.cells());
    if (view.planar)
        writer.put(kFlatSize, d.length, d.width);
    else
    {
        putCells(hits, grid, features.data());
        writer.put(kSize, d.length, d.width, d.top);
        writer.put(kBottomBlock, d.bottom);
        writer.put(kHigh, d.high, d.top);
    }
    writer.put(kOutside, d.outside);
    writer.put(kMatchBlock, view.match);
    writer.put(kDensityBlock, d.density);
    writer.put(kBearingBlock, d.bearing);
    writer.put(kCoverage, d.breadth, d.coverage);
    if (!d.low) return features;
    writer.put(kDepthBlock, d.low->depth);
    writer.put(kNear, d.low->near);
    writer.put(kStraightness, d.low->straightness);
    writer.put(kOnSide, d.low->onSide);
    writer.put(kSurface, d.low->straightness, d.low->depth);
    return features;
}

}  // namespace vdamf
