// SPDX-License-Identifier: BSD-3-Clause
// What becomes of measurements that no motion hypothesis foretold.
#include <gtest/gtest.h>

#include "tracking/estimation/follower.h"

namespace vdamf
{
namespace
{
using test::Follower;
using test::unknownSpeed;

// Which of the two erred is not known, but for what stands.
TEST(MotionSurprises, AreMetHalfwayByWhatMayMove)
{
    MotionOptions options;
    options.independent = false;
    VehicleKalmanFilter filter{options};
    VehicleState state = unknownSpeed();
    state.covariance(kX, kX) = 0.04;
    state.covariance(kSpeed, kSpeed) = 4.0;
    BoxMeasurement m;
    m.box << 4.0, 0.0, 0.0, 4.5, 1.8;
    m.covariance.diagonal() << 0.04, 0.04, 1e-4, 0.01, 0.01;
    const MotionHypotheses h =
        updated(hypothesesFrom(state, options), m, JitterShares(), filter, 11.34);
    EXPECT_NEAR(h.driving.front().mean(kX), 2.0, 0.3);
    EXPECT_GT(h.driving.front().covariance(kX, kX), 0.2);
    EXPECT_LT(h.standing.mean(kX), 0.5);
}

TEST(MotionSurprises, OneJumpOfWhatIsKnownIsAnErrorOfItsMeasurement)
{
    for (const double speed : {0.0, 8.0})
    {
        Follower follower(0.3);
        double x = 0.0;
        for (int k = 0; k < 40; ++k) follower.see(x += 0.1 * speed);
        const MotionHypotheses later = follower.later();
        follower.see((x += 0.1 * speed) - 0.7);
        EXPECT_TRUE(follower.hypotheses.surprised);
        EXPECT_NEAR(follower.state().mean(kSpeed), speed, 0.7) << "not 7 m/s less";
        EXPECT_EQ(follower.hypotheses.standingProbability, later.standingProbability);
        follower.see(x += 0.1 * speed);
        EXPECT_FALSE(follower.hypotheses.surprised);
        EXPECT_NEAR(follower.state().mean(kX), x, 0.15);
    }
}

TEST(MotionSurprises, WhatJumpsAndStaysThereIsThere)
{
    for (const double speed : {0.0, 8.0})
    {
        Follower follower(0.3);
        double x = 0.0;
        for (int k = 0; k < 40; ++k) follower.see(x += 0.1 * speed);
        x -= 0.7;
        for (int k = 0; k < 4; ++k) follower.see(x += 0.1 * speed);
        EXPECT_NEAR(follower.state().mean(kX), x, 0.15);
    }
}

// An occluder that goes by uncovers more and more of a parked car, so that its end seems to move.
TEST(MotionSurprises, WhatStandsDoesNotLeapUnlessItGoesOn)
{
    Follower follower(0.1);
    for (int k = 0; k < 40; ++k) follower.see(0.0);
    for (int k = 1; k <= 3; ++k)
    {
        const double before = follower.hypotheses.driving.front().mean(kSpeed);
        follower.see(0.6 * k);
        const double gain = follower.hypotheses.driving.front().mean(kSpeed) - before;
        EXPECT_LT(gain, 1.01) << "6 m/s in a tenth of a second, sighting " << k;
        EXPECT_LT(follower.state().mean(kSpeed), 0.6 * k);
    }
    for (int k = 4; k <= 12; ++k) follower.see(0.6 * k);
    EXPECT_NEAR(follower.state().mean(kSpeed), 6.0, 0.5) << "it drove all the time";
    EXPECT_NEAR(follower.state().mean(kX), 7.2, 0.2);
}

// However often it is measured.
TEST(MotionSurprises, WhatStandsGainsSpeedByTheTimeThatPasses)
{
    const auto gainOf = [](double interval)
    {
        Follower follower(0.1, interval);
        for (int k = 0; k < 40; ++k) follower.see(0.0);
        const double before = follower.hypotheses.driving.front().mean(kSpeed);
        follower.see(0.7);
        return follower.hypotheses.driving.front().mean(kSpeed) - before;
    };
    EXPECT_LT(gainOf(0.05), 0.51);
    EXPECT_GT(gainOf(0.1), 0.51);
    EXPECT_LT(gainOf(0.1), 1.01);
    EXPECT_GT(gainOf(0.2), 1.01);
    EXPECT_LT(gainOf(0.2), 2.01);
}

// Whether the time without a measurement is one step or ten.
TEST(MotionSurprises, WhatSetOffOutOfSightIsFollowed)
{
    const auto errorAfter = [](int steps)
    {
        constexpr double kUnseen = 1.0;  // s
        constexpr double kFast = 2.5;    // m/s, at its end
        Follower follower(0.05);
        for (int k = 0; k < 60; ++k) follower.see(0.0);
        for (int k = 0; k < steps; ++k) follower.wait(kUnseen / steps);
        double x = 0.5 * kFast * kUnseen;
        follower.seeNow(x);
        follower.see(x += 0.1 * kFast);
        return std::abs(follower.state().mean(kX) - x);
    };
    EXPECT_LT(errorAfter(1), 0.5);
    EXPECT_LT(errorAfter(10), 0.5);
}

// Two measurements at one time, as of two parts.
TEST(MotionSurprises, WhatNoTimePassedForIsTakenAsItIs)
{
    MotionHypotheses h = hypothesesFrom(unknownSpeed(), MotionOptions());
    h.standingProbability = 0.95;
    for (VehicleState& state : h.driving)
    {
        state.covariance(kSpeed, kSpeed) = 0.04;
        state.covariance(kX, kSpeed) = state.covariance(kSpeed, kX) = 0.01;
    }
    VehicleKalmanFilter filter{MotionOptions()};
    BoxMeasurement m;
    m.box << 0.6, 0.0, 0.0, 4.5, 1.8;
    m.covariance.diagonal() << 0.0036, 0.0009, 1e-4, 0.01, 0.01;
    const MotionHypotheses next = updated(h, m, JitterShares(), filter, 11.34);
    EXPECT_TRUE(next.combined(MotionOptions()).mean.allFinite());
    EXPECT_TRUE(next.combined(MotionOptions()).covariance.allFinite());
}

// At 4 m/s^2, as cars do that are in a hurry.
TEST(MotionSurprises, WhatSetsOffAsVehiclesDoIsFollowed)
{
    Follower follower(0.05);
    for (int k = 0; k < 40; ++k) follower.see(0.0);
    double speed = 0.0;
    double x = 0.0;
    for (int k = 0; k < 15; ++k)
    {
        speed += 0.4;
        follower.see(x += 0.1 * speed);
    }
    EXPECT_NEAR(follower.state().mean(kSpeed), speed, 1.0);
    EXPECT_NEAR(follower.state().mean(kX), x, 0.2);
}

}  // namespace
}  // namespace vdamf
