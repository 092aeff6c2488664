// SPDX-License-Identifier: BSD-3-Clause
// How far hits reach along and across a direction.
#pragma once

#include "vdamf/tracking/types/direction.h"
#include "vdamf/tracking/types/hits.h"

namespace vdamf
{
/// Least and greatest places of hits along a direction (x) and to the left of it (y), m.
struct HitBounds
{
    double minX = 1e30, maxX = -1e30, minY = 1e30, maxY = -1e30;
};

HitBounds boundsAlong(const Direction& direction, const Hits& hits);

}  // namespace vdamf
