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
constexpr double kFree = 0.1;           // of what moves, does not follow wheels
constexpr double kStartYawRate = 0.3;   // rad/s
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

VehicleState mixed(const VehicleState& one, const VehicleState& other, double p)
{
    StateVector between = other.mean - one.mean;
    between(kHeading) = wrapAngle(between(kHeading));
    VehicleState state;
    state.mean = one.mean + p * between;
    state.mean(kHeading) = wrapAngle(state.mean(kHeading));
    state.covariance = (1.0 - p) * one.covariance + p * other.covariance +
                       p * (1.0 - p) * between * between.transpose();
    state.width = (1.0 - p) * one.width + p * other.width;
    state.widthVariance = (1.0 - p) * one.widthVariance + p * other.widthVariance;
    return state;
}

// Least and greatest probability stand for none and one: a mean must not lose a share of speed.
double share(double probability)
{
    return std::clamp((probability - kLeast) / (1.0 - 2.0 * kLeast), 0.0, 1.0);
}

double bounded(double probability)
{
    return std::clamp(probability, kLeast, 1.0 - kLeast);
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

VehicleState MotionHypotheses::combined(const MotionOptions& options) const
{
    const double freeShare = share(freeProbability);
    const VehicleState driving =
        freeShare > 0.0 ? mixed(moving, variableAxisOf(free, moving, options), freeShare) : moving;
    return mixed(driving, standing, share(standingProbability));
}

MotionHypotheses hypothesesFrom(const VehicleState& state, const MotionOptions& options)
{
    MotionHypotheses all{state, atRest(state), 0.5, {}, 0.0};
    if (!options.independent) return all;
    all.free = independentOf(state);
    // Across its heading a vehicle may be as fast as along it, if the heading is wrong.
    const Eigen::Vector2d left = rotation(state.mean(kHeading)).col(1);
    all.free.covariance.block<2, 2>(kVelocityX, kVelocityX) +=
        state.covariance(kSpeed, kSpeed) * left * left.transpose();
    all.free.covariance(kYawRate, kYawRate) += kStartYawRate * kStartYawRate;
    all.freeProbability = kFree;
    return all;
}

MotionHypotheses predicted(const MotionHypotheses& h, double dt, VehicleKalmanFilter& filter,
                           const MotionOptions& options)
{
    const double stays = std::exp(-dt / kRestTime);
    MotionHypotheses next = h;
    next.moving = filter.predict(h.moving, dt);
    next.standing = standingLater(h.standing, dt, options);
    next.standingProbability = 0.5 + stays * (h.standingProbability - 0.5);
    if (h.freeProbability > 0.0)
    {
        next.free = filter.predict(h.free, dt);
        next.freeProbability = kFree + stays * (h.freeProbability - kFree);
    }
    return next;
}

MotionHypotheses updated(const MotionHypotheses& h, const BoxMeasurement& measurement,
                         VehicleKalmanFilter& filter, double nisGate)
{
    const auto foretold = [&](const VehicleState& state)
    { return innovationOf(stateAt(state, measurement.lag, filter.options()), measurement); };
    const Innovation moving = foretold(h.moving);
    const Innovation standing = foretold(h.standing);
    MotionHypotheses next = h;
    Innovation driving = moving;  // of the likelier one of those that move
    double weight = 1.0 - h.freeProbability;
    double weightOfOther = 0.0;
    if (h.freeProbability > 0.0)
    {
        const Innovation freely = foretold(h.free);
        const double likelihood = std::exp(evidence(freely, moving, nisGate));
        next.free = updatedState(h.free, measurement, freely.nis(), filter, nisGate);
        const double odds = h.freeProbability / (1.0 - h.freeProbability) * likelihood;
        next.freeProbability = bounded(odds / (1.0 + odds));
        weightOfOther = h.freeProbability * likelihood;
        if (odds > 1.0)
        {
            driving = freely;
            weightOfOther = weight / likelihood;
            weight = h.freeProbability;
        }
    }
    const double odds = h.standingProbability / (1.0 - h.standingProbability) *
                        std::exp(evidence(standing, driving, nisGate)) / (weight + weightOfOther);
    next.standingProbability = bounded(odds / (1.0 + odds));
    next.moving = updatedState(h.moving, measurement, moving.nis(), filter, nisGate);
    if (moving.nis() > nisGate)
        next.moving.covariance(kSpeed, kSpeed) += kSurpriseSigma * kSurpriseSigma;
    next.standing = updatedState(h.standing, measurement, standing.nis(), filter, nisGate);
    if (next.standingProbability < kRefuted)
        next.standing = atRest(share(next.freeProbability) > 0.5
                                   ? variableAxisOf(next.free, next.moving, filter.options())
                                   : next.moving);
    return next;
}

}  // namespace vdamf
