// SPDX-License-Identifier: BSD-3-Clause
// Motion from noisy labels: close to the truth, smooth, and still where it stands.
#include "vdamf/simulation/labelled_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerical_motion.h"
#include "vdamf/simulation/random_stream.h"
#include "vdamf/simulation/segments.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kSmoothing = 0.4;  ///< s

/// Labels at 10 Hz of a point `ahead` of a drive's reference, with noise.
std::vector<LabelledPose> labelsOf(const Trajectory& drive, double end, double noise,
                                   double ahead = 0.0)
{
    RandomStream random(7, 0);
    std::vector<LabelledPose> poses;
    for (int i = 0; 0.1 * i <= end + 1e-9; ++i)
    {
        const MotionState state = drive.at(0.1 * i);
        const double heading = wrapAngle(state.heading + 0.2 * noise * random.gaussian());
        poses.push_back(
            {0.1 * i, state.x + ahead * std::cos(state.heading) + noise * random.gaussian(),
             state.y + ahead * std::sin(state.heading) + noise * random.gaussian(), heading});
    }
    return poses;
}

Trajectory bend()
{
    return Trajectory({0.0, 0.0, 2.9, 8.0, 0.0},
                      parseSegments("keep 3, speed_to 5 1.5, turn 90 10, speed_to 9 1.5", 8.0));
}

TEST(LabelledMotion, FollowsADriveThroughNoise)
{
    const Trajectory drive = bend();
    const Trajectory found = smoothed(labelsOf(drive, 14.0, 0.05, 1.3), 1.3, kSmoothing);
    for (double time = 1.0; time < 13.0; time += 0.1)
    {
        const MotionState expected = drive.at(time);
        const MotionState state = found.at(time);
        EXPECT_NEAR(state.x, expected.x, 0.08) << time;
        EXPECT_NEAR(state.y, expected.y, 0.08) << time;
        EXPECT_NEAR(state.speed, expected.speed, 0.3) << time;
        EXPECT_NEAR(state.yawRate, expected.yawRate, 0.2) << time;
        EXPECT_NEAR(wrapAngle(state.heading - expected.heading), 0.0, 0.03) << time;
    }
}

TEST(LabelledMotion, ExactLabelsOfASteadyDriveAreMet)
{
    const Trajectory drive({4.0, -2.0, 1.1, 7.0, 0.0}, {});
    const Trajectory found = smoothed(labelsOf(drive, 8.0, 0.0), 0.0, kSmoothing);
    for (const double time : {-1.0, 0.0, 2.22, 8.0, 9.5})
    {
        EXPECT_NEAR(found.at(time).x, drive.at(time).x, 1e-9) << time;
        EXPECT_NEAR(found.at(time).speed, 7.0, 1e-9) << time;
    }
}

TEST(LabelledMotion, YawRateAndSpeedAreDerivatives)
{
    const Trajectory found = smoothed(labelsOf(bend(), 14.0, 0.05), 0.0, kSmoothing);
    const double h = 1e-5;
    for (double time = 0.3; time < 14.0; time += 0.21)
    {
        const MotionState a = found.at(time - h);
        const MotionState b = found.at(time + h);
        const MotionState state = found.at(time);
        EXPECT_NEAR((b.heading - a.heading) / (2.0 * h), state.yawRate, 1e-6);
        const double along =
            ((b.x - a.x) * std::cos(state.heading) + (b.y - a.y) * std::sin(state.heading)) /
            (2.0 * h);
        EXPECT_NEAR(along, state.speed, 1e-6);
    }
}

TEST(LabelledMotion, ParkedStandsStillExactly)
{
    const Trajectory parked({10.0, 5.0, 0.7, 0.0, 0.0}, {});
    const std::vector<LabelledPose> labels = labelsOf(parked, 15.0, 0.08);
    const Trajectory found = smoothed(labels, 1.2, kSmoothing);
    const MotionState first = found.at(0.0);
    for (double time = 0.0; time <= 15.0; time += 0.137)
    {
        EXPECT_EQ(found.at(time).x, first.x);
        EXPECT_EQ(found.at(time).heading, first.heading);
        EXPECT_EQ(found.at(time).speed, 0.0);
        EXPECT_EQ(found.at(time).yawRate, 0.0);
    }
}

TEST(LabelledMotion, StopsInBetweenAreStandstills)
{
    const Trajectory drive({0.0, 0.0, 0.0, 6.0, 0.0},
                           parseSegments("keep 2, stop 2, keep 6, speed_to 6 2", 6.0));
    const std::vector<LabelledPose> labels = labelsOf(drive, 15.0, 0.04);
    const std::vector<Standstill> stands = standstills(labels);
    ASSERT_EQ(stands.size(), 1U);
    EXPECT_NEAR(stands[0].begin, 5.0, 0.6);
    EXPECT_NEAR(stands[0].end, 11.0, 0.6);
    const Trajectory found = smoothed(labels, 0.0, kSmoothing);
    for (double time = 5.7; time < 10.5; time += 0.1)
    {
        EXPECT_EQ(found.at(time).speed, 0.0) << time;
        EXPECT_EQ(found.at(time).x, found.at(8.0).x) << time;
    }
    for (double time = 4.0; time < 13.0; time += 0.25) expectContinuousAt(found, time);
}

TEST(LabelledMotion, SlowWalkersDoNotStand)
{
    const Trajectory walk({0.0, 0.0, 0.0, 0.4, 0.0}, {});
    EXPECT_TRUE(standstills(labelsOf(walk, 10.0, 0.03)).empty());
    EXPECT_TRUE(standstills(labelsOf(walk, 1.0, 0.01)).empty());
}

TEST(LabelledMotion, GapsAreBridged)
{
    const Trajectory drive({0.0, 0.0, 0.0, 8.0, 0.0}, {{20.0, 0.0, 0.02}});
    std::vector<LabelledPose> labels = labelsOf(drive, 10.0, 0.0);
    labels.erase(labels.begin() + 40, labels.begin() + 55);
    const Trajectory found = smoothed(labels, 0.0, kSmoothing);
    EXPECT_NEAR(found.at(4.75).x, drive.at(4.75).x, 0.05);
    EXPECT_NEAR(found.at(4.75).y, drive.at(4.75).y, 0.05);
}

TEST(LabelledMotion, BadLabelsAreRefused)
{
    EXPECT_THROW(smoothed({{0.0, 1.0, 2.0, 0.0}}, 0.0, kSmoothing), std::runtime_error);
    EXPECT_THROW(smoothed({{0.0, 1.0, 2.0, 0.0}, {0.0, 1.0, 2.0, 0.0}}, 0.0, kSmoothing),
                 std::runtime_error);
}
}  // namespace
}  // namespace vdamf
