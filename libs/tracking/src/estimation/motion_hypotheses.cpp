// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/motion_hypotheses.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace vdamf
{
namespace
{
constexpr double kRestTime = 1.6;  // s, in which vehicles that stand may start, or stop
// Mean times, s, for which vehicles go on steadily, and for which they brake or turn.
constexpr double kSteadyTime = 4.0;
constexpr double kManoeuvreTime = 2.0;
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

// `other` with probability p; steering as of the first one.
VehicleState mixed(const VehicleState& one, const VehicleState& other, double p)
{
    StateVector between = other.mean - one.mean;
    between(kHeading) = wrapAngle(between(kHeading));
    VehicleState state = one;
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

// Likelihoods of a measurement by hypotheses, relative to the best one. What surprises all of them
// says little: it counts for as much less as it lies outside the gate of the nearest one.
std::vector<double> likelihoods(const std::vector<Innovation>& foretold, double gate)
{
    double nearest = gate;
    for (std::size_t i = 0; i < foretold.size(); ++i)
        nearest = i == 0 ? foretold[i].nis() : std::min(nearest, foretold[i].nis());
    const double weight = std::min(1.0, gate / std::max(1e-9, nearest));
    std::vector<double> logs;
    for (const Innovation& each : foretold)
        logs.push_back(-0.5 * (weight * each.nis() + std::log(each.covariance.determinant())));
    const double best = *std::max_element(logs.begin(), logs.end());
    for (double& each : logs) each = std::exp(std::max(each - best, -kMostEvidence));
    return logs;
}

VehicleState updatedState(const VehicleState& state, BoxMeasurement measurement, double nis,
                          VehicleKalmanFilter& filter, double gate)
{
    if (nis > gate) measurement.covariance *= nis / gate;
    return filter.update(state, measurement);
}

// What follows its wheels, steadily or not.
VehicleState onWheels(const MotionHypotheses& h)
{
    return mixed(h.moving, h.steady, h.steadyProbability);
}

// Each of the two starts from what both know, weighed with the odds that it came from there.
MotionHypotheses interacting(const MotionHypotheses& h, double dt)
{
    const double steadyStays = std::exp(-dt / kSteadyTime);
    const double movingStays = std::exp(-dt / kManoeuvreTime);
    const double moves = 1.0 - h.steadyProbability;
    MotionHypotheses next = h;
    next.steadyProbability = h.steadyProbability * steadyStays + moves * (1.0 - movingStays);
    next.steady = mixed(h.steady, h.moving, moves * (1.0 - movingStays) / next.steadyProbability);
    next.moving = mixed(h.moving, h.steady,
                        h.steadyProbability * (1.0 - steadyStays) / (1.0 - next.steadyProbability));
    return next;
}
}  // namespace

VehicleState MotionHypotheses::combined(const MotionOptions& options) const
{
    const double freeShare = share(freeProbability);
    const VehicleState wheels = onWheels(*this);
    const VehicleState driving =
        freeShare > 0.0 ? mixed(wheels, variableAxisOf(free, wheels, options), freeShare) : wheels;
    return mixed(driving, standing, share(standingProbability));
}

MotionHypotheses hypothesesFrom(const VehicleState& state, const MotionOptions& options)
{
    MotionHypotheses all;
    all.moving = all.steady = state;
    all.steady.steering = Steering::Steady;
    all.standing = atRest(state);
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
    MotionHypotheses next = interacting(h, dt);
    next.moving = filter.predict(next.moving, dt);
    next.steady = filter.predict(next.steady, dt);
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
    std::vector<Innovation> foretold;
    MotionHypotheses next = h;
    const auto update = [&](VehicleState& state)
    {
        foretold.push_back(
            innovationOf(stateAt(state, measurement.lag, filter.options()), measurement));
        state = updatedState(state, measurement, foretold.back().nis(), filter, nisGate);
    };
    for (VehicleState* state : {&next.moving, &next.steady, &next.standing}) update(*state);
    if (foretold.front().nis() > nisGate)
        next.moving.covariance(kSpeed, kSpeed) += kSurpriseSigma * kSurpriseSigma;
    if (h.freeProbability > 0.0) update(next.free);

    const std::vector<double> likelihood = likelihoods(foretold, nisGate);
    const double steady = h.steadyProbability * likelihood[1];
    const double wheels = steady + (1.0 - h.steadyProbability) * likelihood[0];
    next.steadyProbability = bounded(steady / wheels);
    double moves = wheels;
    if (h.freeProbability > 0.0)
    {
        const double free = h.freeProbability * likelihood[3];
        moves = free + (1.0 - h.freeProbability) * wheels;
        next.freeProbability = bounded(free / moves);
    }
    const double stands = h.standingProbability * likelihood[2];
    next.standingProbability = bounded(stands / (stands + (1.0 - h.standingProbability) * moves));
    if (next.standingProbability < kRefuted)
        next.standing = atRest(share(next.freeProbability) > 0.5
                                   ? variableAxisOf(next.free, next.moving, filter.options())
                                   : onWheels(next));
    return next;
}

}  // namespace vdamf
