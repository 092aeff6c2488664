// SPDX-License-Identifier: BSD-3-Clause
// How far boxes reach along a direction, and into each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// Half the extent of a box along a direction (rad), m.
inline double halfAlong(const OrientedBox& box, double direction)
{
    const Direction d = directionOf(direction - box.heading);
    return 0.5 * (std::abs(box.length * d.cos) + std::abs(box.width * d.sin));
}

/// How deep two boxes lie in each other: the shortest move that parts them, m; negative where they
/// are apart.
inline double depthInEachOther(const OrientedBox& a, const OrientedBox& b)
{
    double least = std::numeric_limits<double>::max();
    for (const double heading : {a.heading, b.heading})
        for (const double direction : {heading, heading + 0.5 * kPi})
        {
            const double apart = std::abs(rotation(direction).col(0).dot(a.centre() - b.centre()));
            least = std::min(least, halfAlong(a, direction) + halfAlong(b, direction) - apart);
        }
    return least;
}

}  // namespace vdamf
