// SPDX-License-Identifier: BSD-3-Clause
// What a new vehicle's speed says of its path.
#include "vdamf/tracking/estimation/start_state.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
// Seems to turn with 0.05 1/m; its heading errs along with that.
VehicleState seenTwice(double speed)
{
    VehicleState state;
    state.mean << 0.0, 0.0, 3.1, speed, 0.05, 1.2, 4.5;
    state.covariance.diagonal() << 0.01, 0.01, 4e-4, 0.25, 2.5e-3, 0.2, 0.05;
    state.covariance(kHeading, kCurvature) = state.covariance(kCurvature, kHeading) = -5e-4;
    return state;
}

TEST(StartState, WhatIsFastHardlyTurns)
{
    const VehicleState before = seenTwice(20.0);
    const VehicleState state = withUsualCurvature(before);
    // 2 m/s^2 over 400 m^2/s^2, and no surer of it than that.
    EXPECT_LT(std::abs(state.mean(kCurvature)), 0.001);
    EXPECT_NEAR(std::sqrt(state.covariance(kCurvature, kCurvature)), 0.005, 1e-4);
    // What went with it follows.
    EXPECT_GT(state.mean(kHeading), 3.105);
    EXPECT_LT(state.covariance(kHeading, kHeading), before.covariance(kHeading, kHeading));
    EXPECT_DOUBLE_EQ(state.mean(kSpeed), 20.0);
}

TEST(StartState, WhatIsSlowMayTurn)
{
    const VehicleState state = withUsualCurvature(seenTwice(6.0));
    EXPECT_DOUBLE_EQ(state.mean(kCurvature), 0.05);
    VehicleState free = seenTwice(20.0);
    free.steering = Steering::Independent;
    EXPECT_EQ(withUsualCurvature(free).mean, free.mean);
}

}  // namespace
}  // namespace vdamf
