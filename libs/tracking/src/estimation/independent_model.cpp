// SPDX-License-Identifier: BSD-3-Clause
// Constant velocity and yaw rate, each with white noise: the three pairs are alike.
#include <algorithm>
#include <cmath>

#include "estimation/held_inputs.h"
#include "vdamf/tracking/estimation/motion_model.h"

namespace vdamf
{
namespace
{
constexpr int kPlace[3] = {kX, kY, kHeading};
constexpr int kRate[3] = {kVelocityX, kVelocityY, kYawRate};
constexpr double kTurningPace = 2.0;  // m/s, from which on it turns as it likes
constexpr double kFastest = 100.0;    // m/s
constexpr double kFastestTurn = 6.0;  // rad/s
constexpr double kLeastSize = 0.2;    // m
}  // namespace

StateVector IndependentModel::predicted(const StateVector& state, double dt) const
{
    StateVector next = state;
    for (int k = 0; k < 3; ++k) next(kPlace[k]) += dt * state(kRate[k]);
    next(kHeading) = wrapAngle(next(kHeading));
    return next;
}

StateMatrix IndependentModel::jacobian(const StateVector&, double dt) const
{
    StateMatrix f = StateMatrix::Identity();
    for (int k = 0; k < 3; ++k) f(kPlace[k], kRate[k]) = dt;
    return f;
}

StateMatrix IndependentModel::noise(const StateVector& state, double step) const
{
    const double dt = std::abs(step);
    const double acceleration = std::pow(options_.independentAcceleration, 2) * kHold;
    // What hardly moves does not turn on the spot: a view that changes only makes it seem so.
    const double pace = state.segment<2>(kVelocityX).norm() / kTurningPace;
    const double yaw =
        std::pow(options_.independentYawAcceleration * std::min(1.0, pace), 2) * kHold;
    StateMatrix q = StateMatrix::Zero();
    for (int k = 0; k < 3; ++k)
    {
        const double each = k < 2 ? acceleration : yaw;
        q(kPlace[k], kPlace[k]) = each * dt * dt * dt / 3.0;
        q(kPlace[k], kRate[k]) = q(kRate[k], kPlace[k]) = each * dt * step / 2.0;
        q(kRate[k], kRate[k]) = each * dt;
    }
    q(kX, kX) += options_.slipSigma * options_.slipSigma * dt;
    q(kY, kY) += options_.slipSigma * options_.slipSigma * dt;
    q(kHeading, kHeading) += options_.headingSigma * options_.headingSigma * dt;
    q(kLength, kLength) += options_.sizeSigma * options_.sizeSigma * dt;
    return q;
}

StateVector IndependentModel::bounded(const StateVector& state) const
{
    StateVector next = state;
    next(kHeading) = wrapAngle(state(kHeading));
    next(kVelocityX) = std::clamp(state(kVelocityX), -kFastest, kFastest);
    next(kVelocityY) = std::clamp(state(kVelocityY), -kFastest, kFastest);
    next(kYawRate) = std::clamp(state(kYawRate), -kFastestTurn, kFastestTurn);
    next(kLength) = std::max(kLeastSize, state(kLength));
    return next;
}

}  // namespace vdamf
