// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/lasting_rest.h"

#include <algorithm>
#include <cmath>

#include "estimation/mixed.h"

namespace vdamf
{
namespace
{
constexpr double kRestTime = 1.6;  // s, in which what stands sets off, or stops
}

MotionHypotheses atLastingRest(const MotionHypotheses& predicted, double stoodProbability,
                               double dt)
{
    constexpr double kPace = 2.5;  // m/s, from which vehicles come to stand
    const VehicleState& driving = predicted.driving.front();
    const double speed =
        std::hypot(driving.mean(kSpeed), std::sqrt(driving.covariance(kSpeed, kSpeed)));
    const double rest = 1.0 / (1.0 + speed / kPace);
    if (rest < 0.5) return predicted;
    MotionHypotheses next = predicted;
    next.standingProbability =
        std::max(predicted.standingProbability,
                 rest + std::exp(-dt / kRestTime) * (stoodProbability - rest));
    return next;
}

MotionHypotheses unseen(const MotionHypotheses& hypotheses, double dt)
{
    constexpr double kTurnTime = 0.7;  // s
    MotionHypotheses next = hypotheses;
    for (VehicleState& state : next.driving) state.mean(kCurvature) *= std::exp(-dt / kTurnTime);
    const double stood = hypotheses.standingProbability;
    if (stood < 0.5) return next;
    const double setsOff = stood * (1.0 - std::exp(-dt / kRestTime));
    const double share = setsOff / (setsOff + 1.0 - stood);
    for (VehicleState& state : next.driving)
    {
        const double curvature = state.covariance(kCurvature, kCurvature);
        state = mixed(state, hypotheses.standing, share);
        // Where it steers is as open as it was.
        state.covariance(kCurvature, kCurvature) = curvature;
    }
    return next;
}

}  // namespace vdamf
