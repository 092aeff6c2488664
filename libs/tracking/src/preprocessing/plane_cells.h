// SPDX-License-Identifier: BSD-3-Clause
// The occupied cells of a grid in the plane, and in which of them each hit lies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "preprocessing/cell_bitmap.h"
#include "vdamf/tracking/preprocessing/ground.h"

namespace vdamf
{
struct PlaneCells
{
    static constexpr float kSize = 0.2F;  ///< of a cell, m
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    /// Entries behind the last cell's, for loops over several cells at once.
    static constexpr std::size_t kPadding = 8;

    CellBitmap bitmap;
    // By the cells' numbers in the bitmap:
    std::vector<float> x, y;          ///< means of the hits from the sensor, m; padded
    std::vector<std::uint32_t> hits;  ///< in the cell
    std::vector<std::uint16_t> column, row;
    std::vector<std::uint32_t> ofHit;  ///< the cell of each hit above ground; kNone: not used

    std::size_t size() const { return hits.size(); }
};

/// Hits farther than a kilometre from the sensor, and such that are not finite, are not used.
PlaneCells sortIntoCells(const LadarFrame& frame, const AboveGround& above);

}  // namespace vdamf
