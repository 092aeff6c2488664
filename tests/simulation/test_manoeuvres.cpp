// SPDX-License-Identifier: BSD-3-Clause
// Smooth curvature and named manoeuvres: exact, continuous, and where geometry says they end.
#include "vdamf/simulation/manoeuvres.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "numerical_motion.h"
#include "vdamf/simulation/segments.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

double durationOf(const std::vector<MotionSegment>& segments)
{
    double sum = 0.0;
    for (const MotionSegment& segment : segments) sum += segment.duration;
    return sum;
}

/// Midpoint rule with a million steps, then Richardson's extrapolation.
MotionState integrated(const MotionState& start, const MotionSegment& segment, int steps)
{
    const double dt = segment.duration / steps;
    const double change = (*segment.endCurvature - segment.curvature) / segment.duration;
    MotionState state = start;
    for (int i = 0; i < steps; ++i)
    {
        const double t = (i + 0.5) * dt;
        const double v = start.speed;
        const double a = segment.acceleration;
        const double k = segment.curvature;
        const double heading = start.heading + k * (v * t + 0.5 * a * t * t) +
                               change * (v * t * t / 2.0 + a * t * t * t / 3.0);
        state.x += (v + a * t) * std::cos(heading) * dt;
        state.y += (v + a * t) * std::sin(heading) * dt;
    }
    return state;
}

TEST(SmoothCurvature, PositionsAreExactTo1e9)
{
    for (const MotionSegment& segment :
         {MotionSegment{4.0, 1.0, 0.0, 0.2}, MotionSegment{6.0, -2.0, 0.3, -0.3},
          MotionSegment{10.0, 0.0, -0.25, 0.25}})
    {
        const MotionState start{1.0, 2.0, 0.7, 9.0, 0.0};
        const MotionState coarse = integrated(start, segment, 100000);
        const MotionState fine = integrated(start, segment, 200000);
        const MotionState end = Trajectory(start, {segment}).at(segment.duration);
        EXPECT_NEAR(end.x, fine.x + (fine.x - coarse.x) / 3.0, 1e-9);
        EXPECT_NEAR(end.y, fine.y + (fine.y - coarse.y) / 3.0, 1e-9);
    }
}

TEST(SmoothCurvature, DerivativesAgreeThroughAStandstill)
{
    const Trajectory drive(
        {0.0, 0.0, 0.3, 6.0, 0.0},
        {{3.0, 0.5, 0.0, 0.12}, {2.0, -4.0, 0.12, -0.2}, {5.0, -0.5, -0.2, 0.1}});
    for (double time = -0.5; time < 11.0; time += 0.083) expectDerivativesAt(drive, time);
    for (const double joint : {3.0, 5.0}) expectContinuousAt(drive, joint);
}

TEST(Manoeuvres, LaneChangeEndsOnTheParallelPath)
{
    for (const double speed : {15.0, 4.0, -2.0})
    {
        for (const double offset : {3.5, -2.6})
        {
            const std::vector<MotionSegment> segments = laneChange(speed, offset, 5.0);
            const Trajectory drive({0.0, 0.0, 0.0, speed, 0.0}, segments);
            EXPECT_NEAR(durationOf(segments), 5.0, 1e-12);
            const MotionState end = drive.at(5.0);
            EXPECT_NEAR(end.y, offset, 1e-9);
            EXPECT_NEAR(end.heading, 0.0, 1e-12);
            EXPECT_NEAR(end.yawRate, 0.0, 1e-12);
            for (const double joint : {0.0, 1.25, 3.75, 5.0}) expectContinuousAt(drive, joint);
            for (double time = 0.1; time < 5.0; time += 0.17) expectDerivativesAt(drive, time);
        }
    }
}

TEST(Manoeuvres, TurnChangesTheHeadingByItsAngleWithinItsRadius)
{
    for (const double speed : {8.0, 1.5, -3.0})
    {
        for (const double angle : {0.5 * kPi, -0.2, 6.0})
        {
            const std::vector<MotionSegment> segments = turn(speed, angle, 9.0);
            const double end = durationOf(segments);
            const Trajectory drive({0.0, 0.0, 1.0, speed, 0.0}, segments);
            EXPECT_NEAR(drive.at(end).heading, 1.0 + angle, 1e-12);
            double fastest = 0.0;
            for (double time = 0.0; time < end; time += 0.01)
            {
                fastest = std::max(fastest, std::abs(drive.at(time).yawRate));
            }
            EXPECT_LE(fastest, std::abs(speed) / 9.0 + 1e-12);
            EXPECT_GE(fastest, 0.9 * std::abs(speed) / 9.0);
            expectContinuousAt(drive, 0.0);
            expectContinuousAt(drive, end);
        }
    }
}

TEST(Manoeuvres, SpeedChangesAndStopsAreExact)
{
    const Trajectory drive({0.0, 0.0, 0.0, 6.0, 0.0},
                           parseSegments("keep 1, stop 2, keep 1.5, speed_to -3 1.5, keep 1", 6.0));
    EXPECT_DOUBLE_EQ(drive.at(1.0).x, 6.0);
    EXPECT_EQ(drive.at(4.5).speed, 0.0);
    EXPECT_EQ(drive.at(4.5).x, drive.at(5.4).x);
    EXPECT_DOUBLE_EQ(drive.at(4.5).x, 6.0 + 9.0);
    EXPECT_DOUBLE_EQ(drive.at(7.6).speed, -3.0);
    EXPECT_NEAR(drive.at(8.5).x, 15.0 - 3.0 - 3.0, 1e-12);
}

TEST(Manoeuvres, WhatCannotBeDrivenIsRefused)
{
    EXPECT_THROW(laneChange(10.0, 30.0, 2.0), std::runtime_error);
    EXPECT_THROW(laneChange(0.0, 3.0, 2.0), std::runtime_error);
    EXPECT_THROW(turn(0.0, 1.0, 9.0), std::runtime_error);
    EXPECT_THROW(turn(5.0, 1.0, 0.5), std::runtime_error);
    EXPECT_THROW(speedTo(5.0, 2.0, -1.0), std::runtime_error);
    EXPECT_THROW(keep(0.0), std::runtime_error);
    EXPECT_TRUE(speedTo(5.0, 5.0, 1.0).empty());
}

std::string segmentsError(const char* text, double speed)
{
    try
    {
        parseSegments(text, speed);
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "no error";
}

TEST(Manoeuvres, TextMixesNumbersAndNames)
{
    const auto segments = parseSegments("2 1 0, 1 0 0 0.1, turn 90 10, keep 1", 4.0);
    ASSERT_EQ(segments.size(), 6U);
    EXPECT_EQ(*segments[1].endCurvature, 0.1);
    EXPECT_DOUBLE_EQ(segments[2].endCurvature.value(), 0.1);
    EXPECT_NEAR(segments[3].duration, 0.5 * kPi * 10.0 / 6.0 - 1.0, 1e-12);
}

TEST(Manoeuvres, ErrorsNameTheItemAndWhatWasExpected)
{
    EXPECT_THAT(segmentsError("keep 1, lane_chnge 3 4", 5.0),
                HasSubstr("segment 2 is 'lane_chnge 3 4'"));
    EXPECT_THAT(segmentsError("keep 1, lane_chnge 3 4", 5.0), HasSubstr("lane_change OFFSET_M"));
    EXPECT_THAT(segmentsError("stop 2, turn 90 9", 5.0),
                HasSubstr("segment 2 is 'turn 90 9': it needs"));
    EXPECT_THAT(segmentsError("lane_change 30 2", 5.0), HasSubstr("less than"));
    for (const char* bad :
         {"turn 90", "turn 90 9 1", "stop", "keep x", "1 0 0 2", "1 0 0 0 0", ","})
    {
        EXPECT_THAT(segmentsError(bad, 5.0), HasSubstr("segment 1")) << bad;
    }
}
}  // namespace
}  // namespace vdamf
