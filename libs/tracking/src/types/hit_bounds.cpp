// SPDX-License-Identifier: BSD-3-Clause
#include "types/hit_bounds.h"

#include <algorithm>

#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
HitBounds boundsAlong(const Direction& direction, const Hits& hits)
{
    HitBounds bounds;
    inWideLanes([
        c = direction.cos, s = direction.sin, size = hits.size(), px = hits.x.data(),
        py = hits.y.data(), result = &bounds
    ]() __attribute__((always_inline)) {
        Doubles minX = Doubles{} + 1e30, maxX = -minX, minY = minX, maxY = -minX;
        const auto add = [&](const Doubles& dx, const Doubles& dy) __attribute__((always_inline))
        {
            const Doubles x = c * dx + s * dy;
            const Doubles y = c * dy - s * dx;
            minX = x < minX ? x : minX;
            maxX = x > maxX ? x : maxX;
            minY = y < minY ? y : minY;
            maxY = y > maxY ? y : maxY;
        };
        const auto step = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles x;
            Doubles y;
            loadRepeating(x, px + first, count);
            loadRepeating(y, py + first, count);
            add(x, y);
        };
        inGroupsOf<kLanes<Doubles>>(size, step);
        for (std::size_t k = 0; k < kLanes<Doubles>; ++k)
            *result = {std::min(result->minX, minX[k]), std::max(result->maxX, maxX[k]),
                       std::min(result->minY, minY[k]), std::max(result->maxY, maxY[k])};
    });
    return bounds;
}

}  // namespace vdamf
