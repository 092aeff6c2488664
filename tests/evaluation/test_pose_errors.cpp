// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/pose_errors.h"

#include <gtest/gtest.h>

#include "example_pairs.h"

namespace vdamf
{
namespace
{
PoseError poseErrorOf(const TruthRow& truth, const TrackRow& track)
{
    const Sequence sequence = sequenceOf({{truth, track}});
    return poseErrors(sequence, allPaired(sequence)).at(0);
}

TEST(PoseErrors, OfAPerfectTrackAreZero)
{
    const PoseError e = poseErrorOf(exampleCar(), trackOn(exampleCar()));
    for (const double error : {e.position, e.longitudinal, e.lateral, e.heading, e.headingAxis,
                               e.speed, e.length, e.width, *e.corner})
    {
        EXPECT_EQ(error, 0.0);
    }
    EXPECT_FALSE(e.flipped);
    EXPECT_EQ(e.neesPose, 0.0);
    EXPECT_EQ(e.neesSpeed, 0.0);
    EXPECT_EQ(e.neesSize, 0.0);
    EXPECT_NEAR(*e.range, 10.0, 1e-12);
    EXPECT_EQ(e.points, 80);
    EXPECT_EQ(e.overlap, 0.8);
    EXPECT_FALSE(e.yawRate.has_value());  // no frame before or after
}

TEST(PoseErrors, AShiftFallsOnTheAxesOfTheObject)
{
    const PoseError e = poseErrorOf(exampleCar(), moved(trackOn(exampleCar()), 0.3, -0.1));
    EXPECT_NEAR(e.longitudinal, 0.3, 1e-12);
    EXPECT_NEAR(e.lateral, -0.1, 1e-12);
    EXPECT_NEAR(e.position, std::sqrt(0.1), 1e-12);
    EXPECT_NEAR(*e.corner, std::sqrt(0.1), 1e-12);
    // Equal variances in x and y: 0.1 m^2 / 0.01 m^2.
    EXPECT_NEAR(e.neesPose, 10.0, 1e-9);
}

TEST(PoseErrors, OnlyTheHiddenEndIsWrong)
{
    // 1 m too long at the end that the sensor does not see: the near corner is right.
    TruthRow truth = exampleCar();
    truth.box.heading = 0.0;  // the sensor stands 10 m behind
    TrackRow track = moved(trackOn(truth), 0.5, 0.0);
    track.report.box.length += 1.0;
    const PoseError e = poseErrorOf(truth, track);
    EXPECT_NEAR(*e.corner, 0.0, 1e-12);
    EXPECT_NEAR(e.longitudinal, 0.5, 1e-12);
    EXPECT_NEAR(e.length, 1.0, 1e-12);
    EXPECT_NEAR(e.neesSize, 25.0, 1e-9);
}

TEST(PoseErrors, AFlipIsOneOfHeadingAlone)
{
    TrackRow track = trackOn(exampleCar());
    track.report.box.heading += kPi + 0.02;
    track.report.speed = -5.5;
    const PoseError e = poseErrorOf(exampleCar(), track);
    EXPECT_TRUE(e.flipped);
    EXPECT_NEAR(e.heading, -kPi + 0.02, 1e-12);
    EXPECT_NEAR(e.headingAxis, 0.02, 1e-12);
    EXPECT_NEAR(e.speed, 0.5, 1e-12);  // backwards along a flipped heading: forwards
    EXPECT_NEAR(e.trackSpeed, -5.5, 1e-12);
    EXPECT_NEAR(*e.corner, 0.0, 0.05);
    EXPECT_NEAR(e.neesPose, 0.02 * 0.02 / 0.0025, 1e-9);
    EXPECT_NEAR(e.neesSpeed, 1.0, 1e-9);
}

TEST(PoseErrors, AcrossTheSeamOfTheAngles)
{
    TruthRow truth = exampleCar();
    truth.box.heading = kPi - 0.01;
    TrackRow track = trackOn(truth);
    track.report.box.heading = -kPi + 0.02;
    const PoseError e = poseErrorOf(truth, track);
    EXPECT_NEAR(e.heading, 0.03, 1e-12);
    EXPECT_FALSE(e.flipped);
}

TEST(PoseErrors, TheYawRateOfTheTruthIsTheCentralDifference)
{
    std::vector<std::pair<TruthRow, TrackRow>> rows;
    for (const double time : {100.0, 100.1, 100.2, 100.3, 101.5})
    {
        TruthRow truth = exampleCar(time);
        truth.box.heading = wrapAngle(3.1 + 0.4 * (time - 100.0));  // over the seam
        TrackRow track = trackOn(truth);
        track.report.yawRate = 0.5;
        rows.emplace_back(truth, track);
    }
    const Sequence sequence = sequenceOf(rows);
    const std::vector<PoseError> errors = poseErrors(sequence, allPaired(sequence));
    ASSERT_EQ(errors.size(), 5U);
    EXPECT_FALSE(errors[0].yawRate.has_value());
    EXPECT_NEAR(errors[1].yawRate.value(), 0.1, 1e-9);
    EXPECT_NEAR(errors[2].yawRate.value(), 0.1, 1e-9);
    EXPECT_FALSE(errors[3].yawRate.has_value());  // the next frame is 1.2 s away
    EXPECT_FALSE(errors[4].yawRate.has_value());
}

TEST(PoseErrors, WhatIsNotKnownIsNotMadeUp)
{
    TruthRow truth = exampleCar();
    truth.sensor.reset();
    truth.points = -1;
    TrackRow track = trackOn(truth);
    track.report.covariance.setZero();
    track.report.lengthVariance = 0.0;
    const PoseError e = poseErrorOf(truth, track);
    EXPECT_FALSE(e.corner.has_value());
    EXPECT_FALSE(e.range.has_value());
    EXPECT_FALSE(e.nis.has_value());
    EXPECT_EQ(e.points, -1);
    // A covariance that is none: negative, so that it counts as outside of all bands.
    EXPECT_LT(e.neesPose, 0.0);
    EXPECT_LT(e.neesSpeed, 0.0);
    EXPECT_LT(e.neesSize, 0.0);
}

TEST(PoseErrors, TheSensorOfTheFrameServesRowsWithoutOne)
{
    TruthRow truth = exampleCar();
    truth.sensor.reset();
    Sequence sequence = sequenceOf({{truth, trackOn(truth)}});
    sequence.frames[0].sensor = PlanePose{500.0, -230.0, 0.0};
    EXPECT_NEAR(poseErrors(sequence, allPaired(sequence)).at(0).range.value(), 30.0, 1e-12);
}

}  // namespace
}  // namespace vdamf
