// SPDX-License-Identifier: BSD-3-Clause
// What stands where around the sensor: the nearest hit by bearing.
#pragma once

#include <vector>

namespace vdamf
{
/// Range in the plane of the nearest hit above ground in each of equal sectors, from bearing -pi
/// counter-clockwise; infinite where there is none.
struct RangeProfile
{
    std::vector<float> nearest;  ///< m

    /// In the sector of a bearing (rad, any turn); infinite for an empty profile.
    double at(double bearing) const;
};

}  // namespace vdamf
