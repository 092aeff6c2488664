// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/unseen.h"

#include <algorithm>
#include <cmath>

#include "estimation/mixed.h"
#include "estimation/rest.h"

namespace vdamf
{
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
        // Where it steers is as open as it was, at least.
        double& mixedCurvature = state.covariance(kCurvature, kCurvature);
        mixedCurvature = std::max(mixedCurvature, curvature);
    }
    return next;
}

}  // namespace vdamf
