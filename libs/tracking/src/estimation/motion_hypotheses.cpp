// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/motion_hypotheses.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kRestTime = 1.6;       // s, in which vehicles that stand may start, or stop
constexpr double kLeast = 0.02;         // of a probability: nothing is ruled out
constexpr double kRefuted = 0.05;       // of the standing hypothesis
constexpr double kMostEvidence = 6.0;   // log odds, of one measurement
constexpr double kSurpriseSigma = 1.5;  // m/s, of the speed of a vehicle that left its gate

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

// Log of how much better one foretold the measurement than the other. What surprises both says
// little: it counts for as much less as it lies outside the gate of the better one.
double evidence(const Innovation& one, const Innovation& other, double gate)
{
    const double weight = std::min(1.0, gate / std::max(1e-9, std::min(one.nis(), other.nis())));
    const double volume = std::log(other.covariance.determinant() / one.covariance.determinant());
    return std::clamp(0.5 * (weight * (other.nis() - one.nis()) + volume), -kMostEvidence,
                      kMostEvidence);
}

VehicleState updatedState(const VehicleState& state, BoxMeasurement measurement, double nis,
                          VehicleKalmanFilter& filter, double gate)
{
    if (nis > gate) measurement.covariance *= nis / gate;
    return filter.update(state, measurement);
}
}  // namespace

VehicleState MotionHypotheses::combined() const
{
    StateVector between = standing.mean - moving.mean;
    between(kHeading) = wrapAngle(between(kHeading));
    // Least and greatest probability stand for none and one: a mean must not lose a share of speed.
    const double p = std::clamp((standingProbability - kLeast) / (1.0 - 2.0 * kLeast), 0.0, 1.0);
    VehicleState state;
    state.mean = moving.mean + p * between;
    state.mean(kHeading) = wrapAngle(state.mean(kHeading));
    state.covariance = (1.0 - p) * moving.covariance + p * standing.covariance +
                       p * (1.0 - p) * between * between.transpose();
    state.width = (1.0 - p) * moving.width + p * standing.width;
    state.widthVariance = (1.0 - p) * moving.widthVariance + p * standing.widthVariance;
    return state;
}

MotionHypotheses hypothesesFrom(const VehicleState& state)
{
    return {state, atRest(state), 0.5};
}

MotionHypotheses predicted(const MotionHypotheses& h, double dt, VehicleKalmanFilter& filter,
                           const MotionOptions& options)
{
    const double stays = std::exp(-dt / kRestTime);
    return {filter.predict(h.moving, dt), standingLater(h.standing, dt, options),
            0.5 + stays * (h.standingProbability - 0.5)};
}

MotionHypotheses updated(const MotionHypotheses& h, const BoxMeasurement& measurement,
                         VehicleKalmanFilter& filter, double nisGate)
{
    const auto foretold = [&](const VehicleState& state)
    { return innovationOf(stateAt(state, measurement.lag, filter.options()), measurement); };
    const Innovation moving = foretold(h.moving);
    const Innovation standing = foretold(h.standing);
    const double odds = h.standingProbability / (1.0 - h.standingProbability) *
                        std::exp(evidence(standing, moving, nisGate));
    MotionHypotheses next;
    next.moving = updatedState(h.moving, measurement, moving.nis(), filter, nisGate);
    if (moving.nis() > nisGate)
        next.moving.covariance(kSpeed, kSpeed) += kSurpriseSigma * kSurpriseSigma;
    next.standing = updatedState(h.standing, measurement, standing.nis(), filter, nisGate);
    next.standingProbability = std::clamp(odds / (1.0 + odds), kLeast, 1.0 - kLeast);
    if (next.standingProbability < kRefuted) next.standing = atRest(next.moving);
    return next;
}

}  // namespace vdamf
