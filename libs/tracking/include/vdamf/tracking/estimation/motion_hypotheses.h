// SPDX-License-Identifier: BSD-3-Clause
// Does it drive or does it stand? Both at once, weighed by how well they foretell.
//
// A filter that must follow a car pulling away gives parked cars the speed of its noise. Beside the
// moving vehicle a standing one is tracked, and beside the one that follows its wheels one that
// moves freely; what is reported is their mean, weighed with their probabilities.
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
    VehicleState free;             ///< Steering::Independent
    double freeProbability = 0.0;  ///< among those that move; 0: not tracked

    /// Mean and covariance of the mixture, as a state of the variable axis.
    VehicleState combined(const MotionOptions& options) const;
};

/// All from one state.
MotionHypotheses hypothesesFrom(const VehicleState& state, const MotionOptions& options);

/// All `dt` seconds later.
MotionHypotheses predicted(const MotionHypotheses& hypotheses, double dt,
                           VehicleKalmanFilter& filter, const MotionOptions& options);

/// All after a measurement. One whose NIS is above `nisGate` counts less instead of losing the
/// track. A standing hypothesis that was refuted starts again where the vehicle is.
MotionHypotheses updated(const MotionHypotheses& hypotheses, const BoxMeasurement& measurement,
                         VehicleKalmanFilter& filter, double nisGate);

}  // namespace vdamf
