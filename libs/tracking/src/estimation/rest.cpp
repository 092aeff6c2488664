// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/rest.h"

#include <cmath>

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
    // It neither speeds up nor steers, but seems to wander a little as the view of it changes.
    constexpr double kWander = 0.035;  // m / sqrt(s)
    VehicleState later = state;
    later.covariance(kX, kX) += kWander * kWander * dt;
    later.covariance(kY, kY) += kWander * kWander * dt;
    later.covariance(kHeading, kHeading) += options.headingSigma * options.headingSigma * dt;
    later.covariance(kLength, kLength) += options.sizeSigma * options.sizeSigma * dt;
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
