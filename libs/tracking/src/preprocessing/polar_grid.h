// SPDX-License-Identifier: BSD-3-Clause
// Polar cells around the sensor, and where in them each hit of a frame lies.
#pragma once

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
    int cell(int sector, int ring) const { return sector * rings + ring; }
};

/// The hits of a frame seen from the sensor, arrays of equal length.
struct PolarHits
{
    std::vector<float> x;             ///< east of the sensor, m
    std::vector<float> y;             ///< north of the sensor, m
    std::vector<float> z;             ///< above the sensor, m
    std::vector<float> ring;          ///< PolarGrid::coordinate; 0 where the hit is not used
    std::vector<std::int32_t> sector; ///< -1 where the hit is not used

    std::size_t size() const { return x.size(); }
};

/// Hits out of the options' ranges or not finite are marked as not used.
PolarHits locateHits(const LadarFrame& frame, const GroundOptions& options);

/// The lowest hits of a cell: the candidates for its ground.
struct LowHits
{
    float lowest = 1e9F;        ///< above the sensor, m
    float second = 1e9F;        ///< the next one up, m
    std::int32_t index = -1;       ///< of the lowest hit; -1: the cell is empty
    std::int32_t secondIndex = -1; ///< -1: the cell has one hit at most
};

/// One entry a cell.
std::vector<LowHits> lowestHits(const PolarHits& hits, const PolarGrid& grid);

}  // namespace vdamf
