// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/motion_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "estimation/leaps.h"
#include "estimation/mixed.h"
#include "estimation/rest.h"
#include "estimation/surprise.h"

namespace vdamf
{
namespace
{
// Vehicles hold their speed for 4 s in the mean, then change it for 3 s; their steering they hold
// and change for 4 s each, apart from it. So from one way to another, 1/s; what does both may end
// up either way.
constexpr double kBegins = 1.0 / 4.0;
constexpr double kEndsSpeed = 1.0 / 3.0;
constexpr double kEndsTurn = 1.0 / 4.0;
constexpr double kRates[MotionHypotheses::kWays][MotionHypotheses::kWays] = {
    {0.0, 0.5 * kEndsSpeed, 0.5 * kEndsSpeed}, {kBegins, 0.0, kEndsTurn}, {kBegins, kBegins, 0.0}};
// At the start, as much for what foretells sharply as for what does not.
constexpr std::array<double, MotionHypotheses::kWays> kAtStart{0.5, 0.25, 0.25};
constexpr std::array<Steering, MotionHypotheses::kWays> kSteerings{
    Steering::VariableAxis, Steering::Turning, Steering::Steady};
constexpr double kLeastProbability = 0.02;  // of a probability: nothing is ruled out
constexpr double kLeastStanding = 1e-4;     // of what is known to be fast
constexpr double kLeastOfWays = 5e-4;       // those come back by their rates
constexpr double kRefuted = 0.05;           // of the standing hypothesis
constexpr double kFree = 0.03;              // of what moves, does not follow wheels
constexpr double kStartYawRate = 0.3;       // rad/s
constexpr double kSurpriseSigma = 1.5;      // m/s, of the speed of a vehicle that left its gate

// Least and greatest probability stand for none and one: a mean must not lose a share of speed.
double share(double probability)
{
    return std::clamp((probability - kLeastProbability) / (1.0 - 2.0 * kLeastProbability), 0.0,
                      1.0);
}

double bounded(double probability)
{
    return std::clamp(probability, kLeastProbability, 1.0 - kLeastProbability);
}

using Ways = Mixture::Weights;

// The same in proportion, with a sum of 1; nothing is ruled out.
Ways asProbabilities(Ways weights)
{
    for (const double least : {0.0, kLeastOfWays})
    {
        double sum = 0.0;
        for (double& each : weights) sum += each = std::max(each, least);
        for (double& each : weights) each /= sum;
    }
    return weights;
}

// After a measurement that they foretold so well.
Ways weighed(Ways ways, const Surprises& foretold, double gate)
{
    const auto likelihood = likelihoods(foretold.first(ways.size()), gate);
    for (std::size_t k = 0; k < ways.size(); ++k) ways[k] *= likelihood[k];
    return asProbabilities(ways);
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
    Surprises whole, jitter;

    void add(const PlacedPoint& then, const PlacedPoint& measuredWhole,
             const PlacedPoint& measuredJitter)
    {
        whole.add(surpriseOf(then, measuredWhole));
        jitter.add(surpriseOf(then, measuredJitter));
    }
};

// What lies outside the gate is not jitter: the view has changed, or the vehicle did the
// unexpected. Neither it nor the measurement was as certain as was thought, and which of them erred
// more is not known: the update goes as far as it would have gone, and leaves as much more open.
// Of what does not jump the measurement erred.
VehicleState updatedState(const VehicleState& state, const Measured& measured, double wholeNis,
                          double jitterNis, bool mayJump, VehicleKalmanFilter& filter, double gate)
{
    if (jitterNis <= gate) return filter.update(state, measured.jitter);
    if (wholeNis <= gate) return filter.update(state, measured.whole);
    const double vaguer = wholeNis / gate;
    VehicleState before = state;
    const bool stands = state.covariance(kSpeed, kSpeed) == 0.0;
    if (mayJump && !stands)
    {
        before.covariance *= vaguer;
        before.widthVariance *= vaguer;
    }
    BoxMeasurement measurement = measured.whole;
    measurement.covariance *= vaguer;
    return filter.update(before, measurement);
}

// Probabilities after a measurement: that it stands, and of what moves, that it does so freely.
struct Rest
{
    double standing = 0.0;
    double free = 0.0;
};

// In the order of `foretold`: those that drive, the one that stands, the one that moves freely.
Rest restOf(const MotionHypotheses& h, const Surprises& foretold, double gate)
{
    const auto likelihood = likelihoods(foretold, gate);
    double wheels = 0.0;
    for (std::size_t k = 0; k < h.kWays; ++k) wheels += h.drivingProbability[k] * likelihood[k];
    const double free = h.freeProbability > 0.0 ? h.freeProbability * likelihood[h.kWays + 1] : 0.0;
    const double moves = free + (1.0 - h.freeProbability) * wheels;
    const double stands = h.standingProbability * likelihood[h.kWays];
    return {stands / (stands + (1.0 - h.standingProbability) * moves), free / moves};
}

VehicleState onWheels(const MotionHypotheses& h)
{
    return Mixture(h.driving).of(h.drivingProbability, 0);
}

// How often a vehicle goes over from one way to another, 1/s: calm ones begin to change their speed
// less often.
double rateOf(std::size_t from, std::size_t to, double calm)
{
    return kSteerings[to] == Steering::VariableAxis ? calm * kRates[from][to] : kRates[from][to];
}

// Each starts from what all know, weighed with the odds that it came from there.
MotionHypotheses interacting(const MotionHypotheses& h, double dt, double calm)
{
    MotionHypotheses next = h;
    const Mixture mixture(h.driving);
    for (std::size_t to = 0; to < h.kWays; ++to)
    {
        Ways from{};
        for (std::size_t k = 0; k < h.kWays; ++k)
        {
            double leaves = 0.0;
            for (std::size_t way = 0; way < h.kWays; ++way) leaves += rateOf(k, way, calm);
            const double stays = std::exp(-dt * leaves);
            from[k] = h.drivingProbability[k] *
                      (k == to ? stays : (1.0 - stays) * rateOf(k, to, calm) / leaves);
        }
        next.drivingProbability[to] = std::accumulate(from.begin(), from.end(), 0.0);
        next.driving[to] = mixture.of(from, to);
    }
    return next;
}
}  // namespace

VehicleState MotionHypotheses::combined(const MotionOptions& options) const
{
    const double freeShare = share(freeProbability);
    const double standingShare = share(standingProbability);
    const VehicleState wheels = onWheels(*this);
    const VehicleState moving =
        freeShare > 0.0 ? mixed(wheels, variableAxisOf(free, wheels, options), freeShare) : wheels;
    if (standingShare == 0.0) return moving;
    // What stands has no speed; that it may drive all the same its covariance tells.
    return mixed(moving, standing, standingShare, std::min(standingShare, standingProbability));
}

MotionHypotheses hypothesesFrom(const VehicleState& state, const MotionOptions& options)
{
    MotionHypotheses all;
    for (std::size_t k = 0; k < all.kWays; ++k)
    {
        all.driving[k] = state;
        all.driving[k].steering = kSteerings[k];
        all.drivingProbability[k] = kAtStart[k];
    }
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
    const double calm = h.unrest.calm();
    // What stands is foretold well, and sets off as often as others begin to change their speed.
    MotionHypotheses next = interacting(h, dt, calm + (1.0 - calm) * h.standingProbability);
    for (VehicleState& state : next.driving) state = filter.predict(state, dt, calm);
    next.unrest = h.unrest.later(dt);
    next.sinceMeasured = h.sinceMeasured + dt;
    next.standing = standingLater(h.standing, dt, options);
    const double rest = restProbability(next.driving.front());
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
    const Eigen::Matrix3d less = std::min(1.0, 2.0 * viewChange) * lastingError;
    next.forEach([&](VehicleState& state) { state.covariance.topLeftCorner<3, 3>() += less; });
    return next;
}

MotionHypotheses updated(const MotionHypotheses& h, const BoxMeasurement& measurement,
                         const JitterShares& jitter, VehicleKalmanFilter& filter, double nisGate)
{
    const Measured measured{measurement, withJitterAlone(measurement, jitter)};
    Foretold foretold;
    MotionHypotheses next = h;
    next.sinceMeasured = 0.0;
    const PlacedPoint whole = measuredPoint(measured.whole);
    const PlacedPoint sharpest = measuredPoint(measured.jitter);
    next.forEach(
        [&](const VehicleState& state)
        {
            const VehicleState then = stateAt(state, measurement.lag, filter.options());
            foretold.add(foretoldPoint(then, measurement.fixedPoint), whole, sharpest);
        });
    const Surprises& sharp = foretold.jitter;

    next.unrest = h.unrest.after(sharp.each[h.kWays - 1].nis / 3.0);
    const auto update = [&](bool mayJump, bool withStanding)
    {
        std::size_t number = 0;
        next.forEach(
            [&](VehicleState& state)
            {
                const std::size_t k = number++;
                if (k != h.kWays || withStanding)
                    state = updatedState(state, measured, foretold.whole.each[k].nis,
                                         sharp.each[k].nis, mayJump, filter, nisGate);
            });
    };
    next.surprised = foretold.whole.each.front().nis > nisGate;
    const double nis = sharp.each.front().nis;
    const BoxMeasurement& taken = nis <= nisGate ? measured.jitter : measurement;
    if (const auto vaguer = withoutLeap(h, taken, nis, filter))
    {
        next.forEach([&](VehicleState& state) { state = filter.update(state, *vaguer); });
        next.surprised = true;
        return next;
    }
    if (next.surprised && !h.surprised && isSpeedKnown(h))
    {
        // A single measurement tells nothing else than that it errs; those that follow will.
        update(false, true);
        return next;
    }
    next.drivingProbability = weighed(h.drivingProbability, sharp, nisGate);

    const Rest rests = restOf(h, sharp, nisGate);
    const Rest restsByAll = restOf(h, foretold.whole, nisGate);
    // What surely drives does not stand at once.
    const double least =
        std::clamp(restProbability(h.driving.front()), kLeastStanding, kLeastProbability);
    // What stands seems to move as its view changes: jitter tells that it stands, and no more than
    // the whole error that it does not.
    next.standingProbability =
        std::clamp(std::max(rests.standing, restsByAll.standing), least, 1.0 - kLeastProbability);
    if (h.freeProbability > 0.0) next.freeProbability = bounded(restsByAll.free);

    const bool refuted = next.standingProbability < kRefuted;
    update(true, !refuted);
    if (next.surprised)
        next.driving.front().covariance(kSpeed, kSpeed) += kSurpriseSigma * kSurpriseSigma;
    if (refuted)
        next.standing =
            atRest(share(next.freeProbability) > 0.5
                       ? variableAxisOf(next.free, next.driving.front(), filter.options())
                       : onWheels(next));
    return next;
}

}  // namespace vdamf
