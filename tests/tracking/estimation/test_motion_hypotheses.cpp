// SPDX-License-Identifier: BSD-3-Clause
// Standing and moving vehicles, told apart by how well each foretells.
#include "vdamf/tracking/estimation/motion_hypotheses.h"

#include <gtest/gtest.h>

#include <random>

#include "tracking/estimation/follower.h"

namespace vdamf
{
namespace
{
using test::Follower;
using test::unknownSpeed;

TEST(MotionHypotheses, AParkedCarHasNoSpeed)
{
    Follower follower;
    double worst = 0.0;
    for (int k = 0; k < 100; ++k)
    {
        follower.see(0.0);
        if (k > 10)
            worst = std::max(worst,
                             std::abs(follower.hypotheses.combined(MotionOptions()).mean(kSpeed)));
    }
    EXPECT_LT(worst, 0.15);
    EXPECT_GT(follower.hypotheses.standingProbability, 0.5);
}

TEST(MotionHypotheses, ACarThatPullsAwayIsFollowedAndStopsAgain)
{
    Follower follower;
    double x = 0.0;
    double speed = 0.0;
    const auto drive = [&](double acceleration, int frames)
    {
        for (int k = 0; k < frames; ++k)
        {
            speed = std::max(0.0, speed + 0.1 * acceleration);
            x += 0.1 * speed;
            follower.see(x);
        }
        return follower.hypotheses.combined(MotionOptions()).mean(kSpeed);
    };
    drive(0.0, 30);
    EXPECT_NEAR(drive(2.0, 10), 2.0, 0.5);
    EXPECT_NEAR(drive(2.0, 20), 6.0, 0.4);
    EXPECT_LT(follower.hypotheses.standingProbability, 0.05);
    EXPECT_NEAR(drive(0.0, 20), 6.0, 0.2);
    EXPECT_NEAR(drive(-3.0, 40), 0.0, 0.15);
    EXPECT_GT(follower.hypotheses.standingProbability, 0.5);
}

TEST(MotionHypotheses, WhatGoesOnSteadilyIsKnownBetterThanWhatBrakes)
{
    Follower follower;
    double x = 0.0;
    const auto sigma = [&]
    {
        const VehicleState state = follower.hypotheses.combined(MotionOptions());
        return std::sqrt(state.covariance(kSpeed, kSpeed));
    };
    for (int k = 0; k < 60; ++k) follower.see(x += 1.5);
    EXPECT_GT(follower.hypotheses.drivingProbability.back(), 0.6);
    const double steady = sigma();
    EXPECT_LT(steady, 0.4);
    double speed = 15.0;
    for (int k = 0; k < 15; ++k) follower.see(x += 0.1 * (speed -= 0.5));
    EXPECT_LT(follower.hypotheses.drivingProbability.back(), 0.3);
    EXPECT_GT(sigma(), 1.2 * steady);
    EXPECT_NEAR(follower.hypotheses.combined(MotionOptions()).mean(kSpeed), speed, 2.0 * sigma());
}

TEST(MotionHypotheses, WhatIsForetoldBetterThanTrafficIsKnownBetterAndFollowedAsSoon)
{
    Follower usual(1.0);
    Follower calm(0.3);
    double x = 0.0;
    double speed = 15.0;
    const auto drive = [&](double acceleration, int frames)
    {
        for (int k = 0; k < frames; ++k)
        {
            x += 0.1 * (speed += 0.1 * acceleration);
            usual.see(x);
            calm.see(x);
        }
    };
    const auto variance = [](const Follower& f)
    { return f.hypotheses.combined(MotionOptions()).covariance(kSpeed, kSpeed); };
    drive(0.0, 80);
    EXPECT_LT(calm.hypotheses.unrest.value(), 0.3);
    EXPECT_LT(variance(calm), 0.5 * variance(usual));
    drive(-4.0, 10);
    EXPECT_NEAR(calm.hypotheses.combined(MotionOptions()).mean(kSpeed), speed, 0.6);
    EXPECT_GT(variance(calm), 0.3 * variance(usual));
}

// A lane change at 15 m/s, measured well.
TEST(MotionHypotheses, WhatTurnsKeepsItsSpeedKnown)
{
    const MotionOptions options;
    VehicleKalmanFilter filter{options};
    std::mt19937_64 generator{7};
    std::normal_distribution<double> gauss;
    MotionHypotheses h = hypothesesFrom(unknownSpeed(), options);
    const double swerve = 0.25;  // rad/s
    double x = 0.0;
    double y = 0.0;
    double heading = 0.0;
    for (int k = 0; k < 60; ++k)
    {
        heading += k >= 50 ? 0.1 * swerve : 0.0;
        x += 1.5 * std::cos(heading);
        y += 1.5 * std::sin(heading);
        BoxMeasurement m;
        m.box << x + 0.03 * gauss(generator), y + 0.02 * gauss(generator),
            heading + 0.01 * gauss(generator), 4.5, 1.8;
        m.covariance.diagonal() << 9e-4, 4e-4, 1e-4, 0.01, 0.01;
        h = updated(predicted(h, 0.1, filter, options), m, JitterShares(), filter, 11.34);
        if (k == 49)
        {
            EXPECT_GT(h.drivingProbability[2], 0.5) << "steady";
        }
    }
    EXPECT_GT(h.drivingProbability[1], h.drivingProbability[2]) << "turning";
    const VehicleState state = h.combined(options);
    EXPECT_NEAR(state.yawRate(), swerve, 0.06);
    EXPECT_NEAR(state.mean(kSpeed), 15.0, 0.15);
    EXPECT_LT(std::sqrt(state.covariance(kSpeed, kSpeed)), 0.3);
}

TEST(MotionHypotheses, WhatIsKnownToBeHardlyFasterThanNothingStands)
{
    VehicleKalmanFilter filter{MotionOptions()};
    const auto standingLater = [&](double speed, double sigma)
    {
        VehicleState state = unknownSpeed();
        state.mean(kSpeed) = speed;
        state.covariance(kSpeed, kSpeed) = sigma * sigma;
        MotionHypotheses all = hypothesesFrom(state, MotionOptions());
        all.standingProbability = 0.5;
        for (int k = 0; k < 30; ++k)
        {
            const MotionHypotheses next = predicted(all, 0.1, filter, MotionOptions());
            all.standingProbability = next.standingProbability;
        }
        return all.standingProbability;
    };
    EXPECT_GT(standingLater(0.0, 0.1), 0.75);
    EXPECT_NEAR(standingLater(0.0, 8.0), 0.5, 0.01);
    EXPECT_LT(standingLater(6.0, 0.1), 0.15);
}

// A row of hits between what hides its ends stays where it is for a frame or two.
TEST(MotionHypotheses, WhatDrivesFastDoesNotStandAtOnce)
{
    Follower follower;
    double x = 0.0;
    for (int k = 0; k < 40; ++k) follower.see(x += 1.2);
    EXPECT_LT(follower.hypotheses.standingProbability, 1e-3);
    follower.see(x);
    EXPECT_LT(follower.hypotheses.standingProbability, 0.2);
    EXPECT_GT(follower.hypotheses.combined(MotionOptions()).mean(kSpeed), 8.0);
    for (int k = 0; k < 5; ++k) follower.see(x);
    EXPECT_GT(follower.hypotheses.standingProbability, 0.5) << "nothing is ruled out";
}

// Nothing brakes from the speed of a town to none between two frames.
TEST(MotionHypotheses, WhatDrivesThroughATownDoesNotStandAtOnce)
{
    Follower follower;
    double x = 0.0;
    for (int k = 0; k < 40; ++k) follower.see(x += 0.6);
    EXPECT_LT(follower.hypotheses.standingProbability, 5e-3);
    follower.see(x - 0.6);
    EXPECT_LT(follower.hypotheses.standingProbability, 0.5);
}

// However well it is foretold: cars that wait set off.
TEST(MotionHypotheses, WhatStandsMaySetOffAtAnyTime)
{
    Follower follower(0.1);
    for (int k = 0; k < 100; ++k) follower.see(0.0);
    EXPECT_LT(follower.hypotheses.unrest.calm(), 0.1);
    EXPECT_GT(follower.hypotheses.drivingProbability.front(), 0.02);
    for (double t = 0.1; t < 0.65; t += 0.1) follower.see(t * t);  // at 2 m/s^2
    EXPECT_LT(follower.hypotheses.standingProbability, 0.5);
}

TEST(MotionHypotheses, WhatIsHiddenDrivesOn)
{
    Follower follower;
    double x = 0.0;
    for (int k = 0; k < 40; ++k) follower.see(x += 0.8);
    VehicleKalmanFilter filter{MotionOptions()};
    MotionHypotheses h = follower.hypotheses;
    for (int k = 0; k < 20; ++k) h = predicted(h, 0.1, filter, MotionOptions());
    const VehicleState later = h.combined(MotionOptions());
    EXPECT_NEAR(later.mean(kSpeed), 8.0, 0.3);
    EXPECT_NEAR(later.mean(kX), x + 16.0, 0.8);
}

TEST(MotionHypotheses, MixtureHasTheSpreadOfItsMeans)
{
    MotionOptions wheels;
    wheels.independent = false;
    MotionHypotheses h = hypothesesFrom(unknownSpeed(), wheels);
    for (VehicleState& state : h.driving)
    {
        state.mean(kSpeed) = 4.0;
        state.covariance(kSpeed, kSpeed) = 1.0;
        state.mean(kHeading) = 3.1;
    }
    h.standing.mean(kHeading) = -3.1;
    const VehicleState both = h.combined(MotionOptions());
    EXPECT_NEAR(both.mean(kSpeed), 2.0, 1e-12);
    EXPECT_NEAR(both.covariance(kSpeed, kSpeed), 0.5 + 0.25 * 16.0, 1e-12);
    EXPECT_NEAR(std::abs(both.mean(kHeading)), kPi, 1e-12);

    h.standingProbability = 0.98;  // as likely as it gets
    const VehicleState surelyStands = h.combined(MotionOptions());
    EXPECT_NEAR(surelyStands.mean(kSpeed), 0.0, 1e-12);
    EXPECT_NEAR(surelyStands.covariance(kSpeed, kSpeed), 0.02 * (1.0 + 16.0), 1e-12)
        << "and yet it may drive";
}

// A pedestrian steps aside, which no wheels do.
TEST(MotionHypotheses, WhatMovesAcrossItsHeadingMovesFreely)
{
    MotionOptions options;
    options.independent = true;
    VehicleKalmanFilter filter{options};
    MotionHypotheses h = hypothesesFrom(unknownSpeed(), options);
    for (int k = 0; k < 30; ++k)
    {
        BoxMeasurement m;
        m.box << 0.0, 0.15 * k, 0.0, 4.5, 1.8;
        m.covariance.diagonal() << 0.0036, 0.0036, 1e-4, 0.01, 0.01;
        h = updated(predicted(h, 0.1, filter, options), m, JitterShares(), filter, 11.34);
    }
    EXPECT_GT(h.freeProbability, 0.9);
    EXPECT_LT(h.standingProbability, 0.1);
    EXPECT_NEAR(h.free.mean(kVelocityY), 1.5, 0.15);
    EXPECT_NEAR(h.combined(options).mean(kY), 0.15 * 29, 0.1);
}

}  // namespace
}  // namespace vdamf
