// SPDX-License-Identifier: BSD-3-Clause
// Closed-form motion against numerical integration of the bicycle's equations.
#include "vdamf/simulation/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
const std::vector<MotionSegment> kDrive{
    {2.0, 1.0, 0.0}, {1.5, 0.0, 0.15}, {2.0, -2.0, -0.1}, {1.0, -3.0, 0.02}, {3.0, 0.0, 1e-9}};

/// Midpoint rule with steps of `dt`; ends of segments fall on steps.
MotionState integrated(MotionState state, double until, double dt)
{
    const int steps = static_cast<int>(std::lround(until / dt));
    for (int i = 0; i < steps; ++i)
    {
        double time = (i + 0.5) * dt;
        MotionSegment now;
        for (const MotionSegment& segment : kDrive)
        {
            if (time < segment.duration)
            {
                now = segment;
                break;
            }
            time -= segment.duration;
        }
        const double speed = state.speed + 0.5 * now.acceleration * dt;
        const double heading = state.heading + 0.5 * now.curvature * speed * dt;
        state.x += speed * std::cos(heading) * dt;
        state.y += speed * std::sin(heading) * dt;
        state.heading += now.curvature * speed * dt;
        state.speed += now.acceleration * dt;
        state.yawRate = now.curvature * state.speed;
    }
    return state;
}

TEST(Trajectory, FollowsTheBicyclesEquations)
{
    const MotionState start{3.0, -2.0, 2.5, 6.0, 0.0};
    const Trajectory trajectory(start, kDrive);
    for (const double time : {0.5, 2.5, 4.0, 5.25, 6.25, 8.0, 12.0})
    {
        const MotionState expected = integrated(start, time, 1e-4);
        const MotionState state = trajectory.at(time);
        EXPECT_NEAR(state.x, expected.x, 1e-6) << time;
        EXPECT_NEAR(state.y, expected.y, 1e-6) << time;
        EXPECT_NEAR(state.heading, expected.heading, 1e-9) << time;
        EXPECT_NEAR(state.speed, expected.speed, 1e-9) << time;
    }
}

TEST(Trajectory, YawRateIsTheHeadingsDerivative)
{
    const Trajectory trajectory({0.0, 0.0, 0.0, 8.0, 0.0}, kDrive);
    for (const double time : {1.0, 2.7, 4.4, 6.0, 9.0})
    {
        const double h = 1e-5;
        const double derivative =
            (trajectory.at(time + h).heading - trajectory.at(time - h).heading) / (2.0 * h);
        EXPECT_NEAR(trajectory.at(time).yawRate, derivative, 1e-6) << time;
    }
}

TEST(Trajectory, WithoutSegmentsGoesStraightOnInBothDirectionsOfTime)
{
    const Trajectory trajectory({1.0, 2.0, 0.5, 4.0, 0.0}, {});
    EXPECT_DOUBLE_EQ(trajectory.at(3.0).x, 1.0 + 12.0 * std::cos(0.5));
    EXPECT_DOUBLE_EQ(trajectory.at(-1.0).y, 2.0 - 4.0 * std::sin(0.5));
    EXPECT_DOUBLE_EQ(trajectory.at(100.0).speed, 4.0);
}

TEST(Trajectory, QuarterCircleEndsWhereGeometrySays)
{
    const double radius = 10.0;
    const double duration = 0.5 * 3.14159265358979323846 * radius / 5.0;
    const Trajectory trajectory({0.0, 0.0, 0.0, 5.0, 0.0}, {{duration, 0.0, 1.0 / radius}});
    const MotionState end = trajectory.at(duration + 2.0);
    EXPECT_NEAR(end.x, radius, 1e-12);
    EXPECT_NEAR(end.y, radius + 10.0, 1e-12);
    EXPECT_NEAR(end.yawRate, 0.0, 1e-12);
}

TEST(Trajectory, StandingStaysWhereItIs)
{
    const Trajectory standing({5.0, 6.0, 1.0, 0.0, 0.0}, {});
    EXPECT_EQ(standing.at(50.0).x, 5.0);
    EXPECT_EQ(standing.at(50.0).heading, 1.0);
    EXPECT_EQ(standing.at(50.0).speed, 0.0);
}
}  // namespace
}  // namespace vdamf
