// SPDX-License-Identifier: BSD-3-Clause
// Does it drive or does it stand? Both at once, weighed by how well they foretell.
//
// A filter that must follow a car pulling away gives parked cars the speed of its noise. Beside the
// moving vehicle a standing one is tracked; what is reported is their mean, weighed with their
// probabilities.
#pragma once

#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
struct MotionHypotheses
{
    VehicleState moving;
    VehicleState standing;  ///< speed and curvature are zero
    double standingProbability = 0.5;

    /// Mean and covariance of the mixture.
    VehicleState combined() const;
};

/// Both from one state.
MotionHypotheses hypothesesFrom(const VehicleState& state);

/// Both `dt` seconds later.
MotionHypotheses predicted(const MotionHypotheses& hypotheses, double dt,
                           VehicleKalmanFilter& filter, const MotionOptions& options);

/// Both after a measurement. One whose NIS is above `nisGate` counts less instead of losing the
/// track. A standing hypothesis that was refuted starts again where the vehicle is.
MotionHypotheses updated(const MotionHypotheses& hypotheses, const BoxMeasurement& measurement,
                         VehicleKalmanFilter& filter, double nisGate);

}  // namespace vdamf
