// SPDX-License-Identifier: BSD-3-Clause
// What stands where around the sensor: the nearest hit by bearing; and how far down it looks.
#pragma once

#include <limits>
#include <vector>

namespace vdamf
{
/// Range in the plane of the nearest hit above ground in each of equal sectors, from bearing -pi
/// counter-clockwise; infinite where there is none, zero where the sensor does not look.
struct RangeProfile
{
    std::vector<float> nearest;  ///< m
    /// Of the lowest ray, rise over run: what is near is seen above it only.
    double lowestSlope = -std::numeric_limits<double>::infinity();

    /// In the sector of a bearing (rad, any turn); infinite for an empty profile.
    double at(double bearing) const;
};

}  // namespace vdamf
