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
constexpr double kSteadyTime = 6.0;
constexpr double kManoeuvreTime = 2.0;
constexpr double kLeast = 0.02;         // of a probability: nothing is ruled out
constexpr double kRefuted = 0.05;       // of the standing hypothesis
constexpr double kFree = 0.03;          // of what moves, does not follow wheels
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

// How a hypothesis foretold a measurement.
struct Surprise
{
    double nis = 0.0;
    double logVolume = 0.0;  // of the innovation's covariance
};

Surprise surpriseOf(const VehicleState& state, const BoxMeasurement& measurement)
{
    const Innovation innovation = innovationOf(state, measurement);
    return {innovation.nis(), std::log(innovation.covariance.determinant())};
}

// Likelihoods of a measurement by hypotheses, relative to the best one. What surprises all of them
// says little: it counts for as much less as it lies outside the gate of the nearest one.
std::vector<double> likelihoods(const std::vector<Surprise>& foretold, double gate)
{
    double nearest = gate;
    for (std::size_t i = 0; i < foretold.size(); ++i)
        nearest = i == 0 ? foretold[i].nis : std::min(nearest, foretold[i].nis);
    const double weight = std::min(1.0, gate / std::max(1e-9, nearest));
    std::vector<double> logs;
    logs.reserve(foretold.size());
    for (const Surprise& each : foretold)
        logs.push_back(-0.5 * (weight * each.nis + each.logVolume));
    const double best = *std::max_element(logs.begin(), logs.end());
    for (double& each : logs) each = std::exp(std::max(each - best, -kMostEvidence));
    return logs;
}

// A measured box, whole and with its jitter alone.
struct Measured
{
    const BoxMeasurement& whole;
    BoxMeasurement jitter;
};

// How hypotheses foretold it.
struct Foretold
{
    std::vector<Surprise> whole, jitter;

    void add(const VehicleState& then, const Measured& measured)
    {
        whole.push_back(surpriseOf(then, measured.whole));
        jitter.push_back(surpriseOf(then, measured.jitter));
    }
};

// What lies outside the gate is not jitter: the view has changed, or the vehicle did the
// unexpected. Neither it nor the measurement was as certain as was thought, and which of them erred
// more is not known: the update goes as far as it would have gone, and leaves as much more open.
VehicleState updatedState(const VehicleState& state, const Measured& measured, double wholeNis,
                          double jitterNis, VehicleKalmanFilter& filter, double gate)
{
    if (jitterNis <= gate) return filter.update(state, measured.jitter);
    if (wholeNis <= gate) return filter.update(state, measured.whole);
    const double vaguer = wholeNis / gate;
    VehicleState before = state;
    // What stands does nothing that surprises: there the measurement erred.
    const bool mayMove = state.covariance(kSpeed, kSpeed) > 0.0;
    if (mayMove)
    {
        before.covariance *= vaguer;
        before.widthVariance *= vaguer;
    }
    BoxMeasurement measurement = measured.whole;
    measurement.covariance *= vaguer;
    return filter.update(before, measurement);
}

// In the long run, for what is known to move: what drives on without being seen does not come to
// stand from one frame to the next.
double restProbability(const VehicleState& moving)
{
    constexpr double kPace = 2.5;  // m/s, from which vehicles come to stand
    const double speed = moving.mean(kSpeed);
    const double variance = kPace * kPace + moving.covariance(kSpeed, kSpeed);
    return 0.5 * std::exp(-0.5 * speed * speed / variance);
}

// Probabilities after a measurement: that it stands, and of what moves, that it does so freely.
struct Rest
{
    double standing = 0.0;
    double free = 0.0;
};

Rest restOf(const MotionHypotheses& h, const std::vector<Surprise>& foretold, double gate)
{
    const std::vector<double> likelihood = likelihoods(foretold, gate);
    const double wheels =
        h.steadyProbability * likelihood[1] + (1.0 - h.steadyProbability) * likelihood[0];
    const double free = h.freeProbability > 0.0 ? h.freeProbability * likelihood[3] : 0.0;
    const double moves = free + (1.0 - h.freeProbability) * wheels;
    const double stands = h.standingProbability * likelihood[2];
    return {stands / (stands + (1.0 - h.standingProbability) * moves), free / moves};
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
    const double rest = restProbability(next.moving);
    next.standingProbability = rest + stays * (h.standingProbability - rest);
    if (h.freeProbability > 0.0)
    {
        next.free = filter.predict(h.free, dt);
        next.freeProbability = kFree + stays * (h.freeProbability - kFree);
    }
    return next;
}

MotionHypotheses drifted(const MotionHypotheses& h, const Eigen::Matrix3d& lastingError,
                         double viewChange)
{
    MotionHypotheses next = h;
    next.forEach(
        [&](VehicleState state)
        {
            state.covariance.topLeftCorner<3, 3>() +=
                std::min(1.0, 2.0 * viewChange) * lastingError;
            return state;
        });
    return next;
}

MotionHypotheses updated(const MotionHypotheses& h, const BoxMeasurement& measurement,
                         const JitterShares& jitter, VehicleKalmanFilter& filter, double nisGate)
{
    const Measured measured{measurement, withJitterAlone(measurement, jitter)};
    Foretold foretold;
    MotionHypotheses next = h;
    std::vector<VehicleState*> states{&next.moving, &next.steady, &next.standing};
    if (h.freeProbability > 0.0) states.push_back(&next.free);
    for (const VehicleState* state : states)
        foretold.add(stateAt(*state, measurement.lag, filter.options()), measured);
    const std::vector<Surprise>& sharp = foretold.jitter;

    const std::vector<double> manoeuvring = likelihoods({sharp[0], sharp[1]}, nisGate);
    const double steady = h.steadyProbability * manoeuvring[1];
    const double moving = (1.0 - h.steadyProbability) * manoeuvring[0];
    next.steadyProbability = bounded(steady / (steady + moving));

    const Rest rests = restOf(h, sharp, nisGate);
    const Rest restsByAll = restOf(h, foretold.whole, nisGate);
    // What stands seems to move as its view changes: jitter tells that it stands, and no more than
    // the whole error that it does not.
    next.standingProbability = bounded(std::max(rests.standing, restsByAll.standing));
    if (h.freeProbability > 0.0) next.freeProbability = bounded(restsByAll.free);

    const bool refuted = next.standingProbability < kRefuted;
    for (std::size_t k = 0; k < states.size(); ++k)
        if (states[k] != &next.standing || !refuted)
            *states[k] = updatedState(*states[k], measured, foretold.whole[k].nis, sharp[k].nis,
                                      filter, nisGate);
    if (foretold.whole.front().nis > nisGate)
        next.moving.covariance(kSpeed, kSpeed) += kSurpriseSigma * kSurpriseSigma;
    if (refuted)
        next.standing = atRest(share(next.freeProbability) > 0.5
                                   ? variableAxisOf(next.free, next.moving, filter.options())
                                   : onWheels(next));
    return next;
}

}  // namespace vdamf
