// SPDX-License-Identifier: BSD-3-Clause
// Polar cells around the sensor, and where in them each hit of a frame lies.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vdamf/tracking/preprocessing/ground.h"

namespace vdamf
{
/// Sectors of equal angle times rings that grow with the square of the range, as the spacing of
/// a spinning LADAR's circles on flat ground does: 0.45 m at 3 m, 1 m at 20 m, 5 m at 80 m.
struct PolarGrid
{
    static constexpr int kSectors = 256;
    static constexpr float kRingScale = 80.0F;
    static constexpr float kHalfRange = 30.0F;  ///< where half of kRingScale is reached, m

    int rings = 0;  ///< of a sector, from the sensor to the largest range

    explicit PolarGrid(double maxRange)
        : rings(static_cast<int>(coordinate(static_cast<float>(maxRange))) + 1)
    {
    }

    /// Rings from the sensor to the range; a ring's middle is at n + 0.5.
    static float coordinate(float range) { return kRingScale * range / (range + kHalfRange); }
    static float range(float coordinate)
    {
        return kHalfRange * coordinate / (kRingScale - coordinate);
    }

    int cells() const { return kSectors * rings; }
    /// Ring by ring, so that what is done sector by sector runs over neighbours in memory.
    static int cell(int sector, int ring) { return ring * kSectors + sector; }
};

/// Where the hits of a frame lie, arrays as long as its points. Small on purpose: the time that
/// ground removal takes is mostly the memory that it touches, so nobody fills it with zeros before.
struct PolarHits
{
    Eigen::Vector3f shift = Eigen::Vector3f::Zero();  ///< from the points to sensor coordinates, m
    Eigen::ArrayXf ring;  ///< PolarGrid::coordinate; negative where not used
    Eigen::Array<std::uint16_t, Eigen::Dynamic, 1> cell;  ///< 0 where not used
};

/// Hits out of the options' ranges or not finite are marked as not used.
PolarHits locateHits(const LadarFrame& frame, const GroundOptions& options);

/// A hit in sensor coordinates (world axes), m.
struct LowHit
{
    static constexpr float kNoHit = 1e9F;
    float z = kNoHit;
    float x = 0.0F, y = 0.0F;

    bool seen() const { return z < kNoHit; }
};

/// Hits of all cells, one a cell, as arrays over the cells.
struct CellHits
{
    std::vector<float> z, x, y;

    explicit CellHits(std::size_t cells) : z(cells, LowHit::kNoHit), x(cells), y(cells) {}

    LowHit at(std::size_t cell) const { return {z[cell], x[cell], y[cell]}; }
};

/// The two lowest hits of each cell: the candidates for its ground.
struct LowHits
{
    CellHits lowest;
    CellHits second;
};

LowHits lowestHits(const PointCloud& points, const PolarHits& hits, const PolarGrid& grid);

}  // namespace vdamf
