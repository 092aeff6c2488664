// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/unseen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/mixed.h"
#include "estimation/rest.h"

namespace vdamf
{
namespace
{
// A turn that nobody sees may have ended: those of lane changes do so soon, those of junctions are
// tighter and last longer.
VehicleState straightened(VehicleState state, double dt)
{
    constexpr double kSwerveTime = 0.7;  // s
    constexpr double kTurnTime = 2.0;    // s
    constexpr double kTightTurn = 0.05;  // 1/m
    double& curvature = state.mean(kCurvature);
    const double tightness = std::min(1.0, std::abs(curvature) / kTightTurn);
    const double goesOn = std::exp(-dt / (kSwerveTime + tightness * (kTurnTime - kSwerveTime)));
    state.covariance(kCurvature, kCurvature) += goesOn * (1.0 - goesOn) * curvature * curvature;
    curvature *= goesOn;
    return state;
}
}  // namespace

MotionHypotheses unseen(const MotionHypotheses& hypotheses, double dt)
{
    MotionHypotheses next = hypotheses;
    for (VehicleState& state : next.driving) state = straightened(std::move(state), dt);
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
