// SPDX-License-Identifier: BSD-3-Clause
// The plane that the ground near the sensor lies in: its height is not known in advance.
#pragma once

#include <optional>

#include "preprocessing/polar_grid.h"

namespace vdamf
{
/// z = height + slopeX * x + slopeY * y, in metres from the sensor.
struct GroundPlane
{
    float height = 0.0F;
    float slopeX = 0.0F;
    float slopeY = 0.0F;

    float at(float x, float y) const { return height + slopeX * x + slopeY * y; }
};

/// The plane with the most low hits of cells within 25 m in it and few below it. Nothing where
/// too few hits agree: the frame shows no ground.
std::optional<GroundPlane> findGroundPlane(const PolarGrid& grid, const LowHits& lowHits,
                                           const GroundOptions& options);

}  // namespace vdamf
