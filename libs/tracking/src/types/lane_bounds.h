// SPDX-License-Identifier: BSD-3-Clause
// Least and greatest of many numbers, and of the coordinates of points, some of them at a time.
#pragma once

#include <algorithm>
#include <cstddef>

#include "types/lanes.h"

namespace vdamf
{
/// Each lane's own; of no points, from `none` down to -`none`.
template <class Lanes>
struct LaneBounds
{
    using Number = decltype(Lanes{}[0] + Lanes{}[0]);

    explicit LaneBounds(Number none) : minX(Lanes{} + none), maxX(-minX), minY(minX), maxY(maxX) {}

    [[gnu::always_inline]] void add(const Lanes& x, const Lanes& y)
    {
        minX = x < minX ? x : minX;
        maxX = x > maxX ? x : maxX;
        minY = y < minY ? y : minY;
        maxY = y > maxY ? y : maxY;
    }

    /// Of all lanes, into something with the same members.
    template <class Bounds>
    [[gnu::always_inline]] void growTo(Bounds& all) const
    {
        for (std::size_t k = 0; k < kLanes<Lanes>; ++k)
        {
            all.minX = std::min(all.minX, minX[k]);
            all.maxX = std::max(all.maxX, maxX[k]);
            all.minY = std::min(all.minY, minY[k]);
            all.maxY = std::max(all.maxY, maxY[k]);
        }
    }

    Lanes minX, maxX, minY, maxY;
};

/// Of one number at least.
float leastOf(const float* numbers, std::size_t count);
float greatestOf(const float* numbers, std::size_t count);

}  // namespace vdamf
