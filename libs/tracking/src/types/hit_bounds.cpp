// SPDX-License-Identifier: BSD-3-Clause
#include "types/hit_bounds.h"

#include <cstddef>

#include "types/lane_bounds.h"
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
        LaneBounds<Doubles> each(result->minX);
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles x;
            Doubles y;
            loadRepeating(x, px + first, count);
            loadRepeating(y, py + first, count);
            each.add(c * x + s * y, c * y - s * x);
        };
        inGroupsOf<kLanes<Doubles>>(size, add);
        each.growTo(*result);
    });
    return bounds;
}

}  // namespace vdamf
