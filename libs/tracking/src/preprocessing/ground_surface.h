// SPDX-License-Identifier: BSD-3-Clause
// The height of the ground in every polar cell, seen or hidden.
#pragma once

#include <vector>

#include "preprocessing/ground_plane.h"
#include "preprocessing/polar_grid.h"

namespace vdamf
{
/// Height of the ground over the plane at the edges of each ring of each sector: the entries of a
/// cell's number, and of that plus kSectors, are the heights at its inner and its outer edge.
struct GroundSurface
{
    GroundPlane plane;
    std::vector<float> height;  ///< over the plane, m
};

/// Follows the ground outwards from the sensor, all sectors side by side: a Kalman filter over
/// height and slope for each, with the low hits of the cells as observations. What lies out of
/// the gate of the prediction is no ground (an object, a mirror image); where no ground is seen
/// the neighbouring sectors and the slope from inside carry it on. A second pass inwards, as in
/// a two-filter smoother, uses the ground behind an object too.
GroundSurface followGround(const PolarGrid& grid, const LowHits& lowHits, const GroundPlane& plane);

}  // namespace vdamf
