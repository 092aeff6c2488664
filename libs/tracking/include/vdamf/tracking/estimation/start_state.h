// SPDX-License-Identifier: BSD-3-Clause
// What is known of a vehicle that was seen once.
#pragma once

#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
/// State from a first measurement: at rest, give or take `speedSigma` (m/s); the axle at its prior.
/// Sizes are those measured, after a car's where that fits (assumeVehicleSize). World frame, also
/// for the sensor.
VehicleState startState(const Measurement& measurement, const Eigen::Vector2d& sensor,
                        double speedSigma, const VisibilityOptions& visibility,
                        const MotionOptions& motion);

}  // namespace vdamf
