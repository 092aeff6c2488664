// SPDX-License-Identifier: BSD-3-Clause
// No vehicle leaps: what a measurement makes of a known speed may be an error of the measurement.
#pragma once

#include <optional>

#include "vdamf/tracking/estimation/motion_hypotheses.h"

namespace vdamf
{
/// Whether it is known what it does: no vehicle jumps from there.
bool isSpeedKnown(const MotionHypotheses& hypotheses);

/// The measurement of what likely stands, and whose speed is known to 0.7 m/s, so vague that it
/// gives it no more speed than vehicles gain from one frame to the next (10 m/s^2); nothing where
/// it gives no more as it is, what else is measured, or no time has passed. `nis`: of the
/// innovation.
std::optional<BoxMeasurement> withoutLeap(const MotionHypotheses& hypotheses,
                                          const BoxMeasurement& measurement, double nis,
                                          VehicleKalmanFilter& filter);

}  // namespace vdamf
