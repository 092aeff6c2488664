// SPDX-License-Identifier: BSD-3-Clause
// Does it drive, and steadily, or does it stand? All at once, weighed by how well they foretell.
//
// A filter that must follow a car that brakes and turns gives parked cars the speed of its noise,
// and cars that go on steadily more uncertainty than they have. Beside the vehicle that does both,
// one that turns at its speed, a steady and a standing one are tracked, and beside those that
// follow their wheels one that moves freely; what is reported is their mean, weighed with their
// probabilities.
#pragma once

#include <array>
#include <cstddef>

#include "vdamf/tracking/estimation/jitter.h"
#include "vdamf/tracking/estimation/unrest.h"
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
struct MotionHypotheses
{
    static constexpr std::size_t kWays = 3;
    /// Follow their wheels: Steering::VariableAxis, Turning, Steady.
    std::array<VehicleState, kWays> driving;
    std::array<double, kWays> drivingProbability{};  ///< among those, their sum is 1
    Unrest unrest;                                   ///< of the steady one
    VehicleState standing;                           ///< speed and curvature are zero
    double standingProbability = 0.5;
    VehicleState free;             ///< Steering::Independent
    double freeProbability = 0.0;  ///< among those that move; 0: not tracked
    bool surprised = false;        ///< the last measurement lay outside the gate of the first
    double sinceMeasured = 0.0;    ///< s; a glance counts as a measurement

    /// Mean and covariance of the mixture, as a state of the variable axis.
    VehicleState combined(const MotionOptions& options) const;

    /// Calls `visit` with the state of each hypothesis that is tracked.
    template <class Visit>
    void forEach(Visit&& visit)
    {
        for (VehicleState& state : driving) visit(state);
        visit(standing);
        if (freeProbability > 0.0) visit(free);
    }
};

/// All from one state.
MotionHypotheses hypothesesFrom(const VehicleState& state, const MotionOptions& options);

/// All `dt` seconds later. What moves steadily may begin to turn or to brake, and the other way
/// round: those are mixed as in an interacting multiple model filter.
MotionHypotheses predicted(const MotionHypotheses& hypotheses, double dt,
                           VehicleKalmanFilter& filter, const MotionOptions& options);

/// All with poses less certain by what the lasting error of measurements (covariance of x, y,
/// heading) is another one after a change of view (changeOfView): that is no motion.
MotionHypotheses drifted(const MotionHypotheses& hypotheses, const Eigen::Matrix3d& lastingError,
                         double viewChange);

/// All after a measurement, of whose variance a share is jitter. Where its NIS is above `nisGate`,
/// both it and what may move are that much less certain, and of what stands it alone; the first
/// time that no hypothesis foretold one of a vehicle whose speed was known, it alone for all. One
/// by which what stood would set off faster than vehicles can is an error, and as vague as it takes
/// for that. A standing hypothesis that was refuted starts again where the vehicle is.
MotionHypotheses updated(const MotionHypotheses& hypotheses, const BoxMeasurement& measurement,
                         const JitterShares& jitter, VehicleKalmanFilter& filter, double nisGate);

}  // namespace vdamf
