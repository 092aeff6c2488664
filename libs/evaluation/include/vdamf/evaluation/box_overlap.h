// SPDX-License-Identifier: BSD-3-Clause
// Overlap of oriented boxes in the horizontal plane.
#pragma once

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// Area of the intersection, m^2 (polygon clipping; exact up to rounding).
double intersectionArea(const OrientedBox& a, const OrientedBox& b);

/// Bird's-eye intersection over union, 0..1; 0 where both are empty.
double birdsEyeIou(const OrientedBox& a, const OrientedBox& b);

}  // namespace vdamf
