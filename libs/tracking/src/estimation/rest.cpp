// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/rest.h"

#include <cmath>

#include "vdamf/tracking/estimation/variable_axis_model.h"

namespace vdamf
{
VehicleState atRest(const VehicleState& state)
{
    VehicleState still = state;
    for (const int row : {kSpeed, kCurvature})
    {
        still.mean(row) = 0.0;
        still.covariance.row(row).setZero();
        still.covariance.col(row).setZero();
    }
    return still;
}

VehicleState standingLater(const VehicleState& state, double dt, const MotionOptions& options)
{
    VehicleState later = state;
    const StateMatrix noise = processNoise(state.mean, dt, options);
    for (const int row : {kX, kY, kHeading, kLength}) later.covariance(row, row) += noise(row, row);
    return later;
}

double restProbability(const VehicleState& moving)
{
    constexpr double kPace = 2.5;      // m/s, from which vehicles come to stand
    constexpr double kBraking = 1.75;  // m/s, that they lose before it shows
    const double speed = moving.mean(kSpeed);
    const double speedVariance = moving.covariance(kSpeed, kSpeed);
    // Of those that are known to be hardly faster than nothing few drive at just that speed.
    const double slow = 1.0 / (1.0 + std::hypot(speed, std::sqrt(speedVariance)) / kPace);
    if (slow > 0.5) return slow;
    return 0.5 * std::exp(-0.5 * speed * speed / (kBraking * kBraking + speedVariance));
}

}  // namespace vdamf
