// SPDX-License-Identifier: BSD-3-Clause
// What is known of a vehicle that was seen once.
#pragma once

#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
/// What is known of a new vehicle's speed along its heading, m/s.
struct StartSpeed
{
    double mean = 0.0;
    double sigma = 16.0;
};

/// State from a first measurement, with the axle at its prior.
/// Sizes are those measured, after a car's where that fits (assumeVehicleSize). World frame, also
/// for the sensor.
VehicleState startState(const Measurement& measurement, const Eigen::Vector2d& sensor,
                        const StartSpeed& speed, const VisibilityOptions& visibility,
                        const MotionOptions& motion);

}  // namespace vdamf
