// SPDX-License-Identifier: BSD-3-Clause
// Named manoeuvres as motion segments. The curvature is continuous and 0 at both ends.
#pragma once

#include <vector>

#include "vdamf/simulation/trajectory.h"

namespace vdamf
{
// `speed` is that at the begin, m/s. All throw std::runtime_error that says what cannot be driven.

/// Straight on: "keep DURATION_S".
std::vector<MotionSegment> keep(double duration);

/// Straight to another speed, also through a standstill: "speed_to SPEED_MPS ACCELERATION_MPS2"
/// (the acceleration's amount, above 0), and "stop ACCELERATION_MPS2".
std::vector<MotionSegment> speedTo(double speed, double target, double acceleration);

/// Changes the heading by an angle in rad (positive: counter-clockwise) with the constant speed.
/// The radius is the smallest on the way, reached after the steering wheel has turned for a third
/// of the manoeuvre, or 1 s if that is less: "turn ANGLE_DEG RADIUS_M".
std::vector<MotionSegment> turn(double speed, double angle, double radius);

/// Ends on a parallel path, `offset` m to the left of the heading, with the constant speed; in
/// reverse as well: "lane_change OFFSET_M DURATION_S".
std::vector<MotionSegment> laneChange(double speed, double offset, double duration);

}  // namespace vdamf
