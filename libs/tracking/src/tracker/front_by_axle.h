// SPDX-License-Identifier: BSD-3-Clause
// Which end of a vehicle that turns is its front: the axle that steers swings out, the other one
// follows its heading.
#pragma once

#include <vector>

#include "tracker/track.h"

namespace vdamf
{
/// Log odds that the front lies where the headings of a path's boxes point rather than behind, 4 at
/// most: that the point which moves along the heading, without any slip, lies in the rear half. 0
/// where the path does not turn or is too short, or the vehicle may be articulated.
double frontByAxle(const std::vector<PathPoint>& path, const MotionOptions& motion);

}  // namespace vdamf
