// SPDX-License-Identifier: BSD-3-Clause
// What is not seen where it should be.
#include "vdamf/tracking/estimation/unseen.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tracking/decompositions.h"

namespace vdamf
{
namespace
{
constexpr double kFrame = 0.1;  // s

// Stands at x = 10 m, or drives on from x = 12 m.
MotionHypotheses seemingly(double speed, double speedSigma, double standing)
{
    VehicleState state;
    state.mean << 10.0, 0.0, 0.0, speed, 0.02, 1.2, 4.5;
    state.covariance.diagonal() << 0.01, 0.01, 1e-4, speedSigma * speedSigma, 2.5e-3, 0.2, 0.05;
    MotionHypotheses all = hypothesesFrom(state, MotionOptions());
    for (VehicleState& driving : all.driving) driving.mean(kX) = 12.0;
    all.standingProbability = standing;
    return all;
}

TEST(Unseen, WhatStoodSetsOffFromWhereItStood)
{
    const MotionHypotheses all = unseen(seemingly(1.0, 0.5, 0.9), kFrame);
    const MotionHypotheses moving = unseen(seemingly(1.0, 0.5, 0.1), kFrame);
    const double steering = moving.driving.front().covariance(kCurvature, kCurvature);
    for (const VehicleState& driving : all.driving)
    {
        EXPECT_LT(driving.mean(kX), 11.5);
        EXPECT_LT(driving.mean(kSpeed), 0.7);
        // Where it has gone to is no surer.
        EXPECT_GT(driving.covariance(kX, kX), 0.5);
        EXPECT_EQ(driving.covariance(kCurvature, kCurvature), steering);
    }
}

// A sharp curvature, known well, against none of what stands.
TEST(Unseen, CovariancesStayPositive)
{
    MotionHypotheses all = seemingly(1.0, 0.5, 0.9);
    for (VehicleState& driving : all.driving)
    {
        driving.mean(kCurvature) = 0.15;
        driving.covariance(kCurvature, kCurvature) = 1e-4;
    }
    for (int frame = 0; frame < 20; ++frame)
    {
        all = unseen(all, kFrame);
        for (const VehicleState& driving : all.driving)
            EXPECT_GE(smallestEigenvalue(driving.covariance), 0.0) << frame;
    }
}

TEST(Unseen, WhatDroveDrivesOnStraighter)
{
    const MotionHypotheses before = seemingly(6.0, 0.5, 0.1);
    const MotionHypotheses all = unseen(before, kFrame);
    EXPECT_EQ(all.driving.front().mean(kSpeed), 6.0);
    EXPECT_EQ(all.driving.front().mean(kX), 12.0);
    EXPECT_LT(std::abs(all.driving.front().mean(kCurvature)), 0.0186);
}

// As of what either goes on turning or goes straight on: so much more of it is open.
TEST(Unseen, WhetherATurnGoesOnIsOpen)
{
    MotionHypotheses before = seemingly(6.0, 0.5, 0.1);
    for (VehicleState& driving : before.driving) driving.mean(kCurvature) = 0.07;
    const VehicleState after = unseen(before, kFrame).driving.front();
    const double goesOn = after.mean(kCurvature) / 0.07;
    EXPECT_NEAR(after.covariance(kCurvature, kCurvature),
                2.5e-3 + goesOn * (1.0 - goesOn) * 0.07 * 0.07, 1e-12);
}

TEST(Unseen, TurnsOfJunctionsLastLongerThanThoseOfLaneChanges)
{
    const auto leftAfterASecond = [](double curvature)
    {
        MotionHypotheses all = seemingly(6.0, 0.5, 0.1);
        for (VehicleState& driving : all.driving) driving.mean(kCurvature) = curvature;
        for (int frame = 0; frame < 10; ++frame) all = unseen(all, kFrame);
        return all.driving.front().mean(kCurvature) / curvature;
    };
    EXPECT_GT(leftAfterASecond(0.08), 0.55);
    EXPECT_LT(leftAfterASecond(0.01), 0.35);
    EXPECT_EQ(leftAfterASecond(-0.08), leftAfterASecond(0.08));
}

}  // namespace
}  // namespace vdamf
