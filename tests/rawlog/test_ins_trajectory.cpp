// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/ins_trajectory.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>
#include <random>

#include "example_car.h"
#include "example_objects.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservationRobotPose;
using test::Car;
using test::headingError;
using test::kStart;
using test::robotPose;

TEST(InsTrajectory, FollowsACarThroughPi)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i <= 300; ++i) ins.insert(robotPose(0.1 * i));
    double position = 0.0;
    double heading = 0.0;
    for (double t = 0.0; t <= 30.0; t += 0.0037)
    {
        const auto pose = ins.at(kStart + t);
        ASSERT_TRUE(pose) << t;
        EXPECT_NEAR(kStart + t, pose->time, 1e-6);
        position = std::max(position, (pose->position - Car::fromStart(t)).norm());
        heading = std::max(heading, headingError(*pose, t));
    }
    // Linear interpolation would be 6 mm off.
    EXPECT_LT(position, 1e-3);
    EXPECT_LT(heading, 1e-4);
    EXPECT_EQ("CObservationRobotPose 'ins'", ins.sourceName());
    EXPECT_EQ("40.0000 0.0000 0.0000 m", ins.originText());
    EXPECT_EQ(301u, ins.samplesTaken());
}

TEST(InsTrajectory, KeepsRollAndPitch)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i <= 3; ++i) ins.insert(robotPose(0.1 * i));
    const auto pose = ins.at(kStart + 0.15);
    ASSERT_TRUE(pose);
    const Eigen::Vector3d forward = pose->attitude * Eigen::Vector3d::UnitX();
    const Eigen::Vector3d left = pose->attitude * Eigen::Vector3d::UnitY();
    EXPECT_NEAR(-std::sin(0.02), forward.z(), 1e-6);
    EXPECT_NEAR(std::cos(0.02) * std::sin(-0.01), left.z(), 1e-6);
}

TEST(InsTrajectory, HonoursTheSensorsPlace)
{
    InsTrajectory ins{InsOptions{}};
    const mrpt::poses::CPose3D mounting(1.0, -0.5, 2.0, 0.7, 0.1, 0.2);
    for (int i = 0; i <= 20; ++i)
    {
        CObservationRobotPose observation = robotPose(0.1 * i);
        observation.pose.mean = observation.pose.mean + mounting;
        observation.sensorPose = mounting;
        ins.insert(observation);
    }
    for (const double t : {0.0, 0.33, 1.97})
    {
        const auto pose = ins.at(kStart + t);
        ASSERT_TRUE(pose);
        EXPECT_LT((pose->position - Car::fromStart(t)).norm(), 1e-3) << t;
        EXPECT_LT(headingError(*pose, t), 1e-4) << t;
    }
}

TEST(InsTrajectory, HasNoPoseInsideAGap)
{
    InsTrajectory ins{InsOptions{}};
    for (const double t : {0.0, 0.1, 0.2, 0.9, 1.0}) ins.insert(robotPose(t));
    EXPECT_TRUE(ins.at(kStart + 0.15));
    EXPECT_TRUE(ins.at(kStart + 0.3));  // extrapolated
    EXPECT_FALSE(ins.at(kStart + 0.5));
    EXPECT_TRUE(ins.at(kStart + 0.8));  // backwards
    EXPECT_LT((ins.at(kStart + 0.8)->position - Car::fromStart(0.8)).norm(), 0.06);
}

TEST(InsTrajectory, ExtrapolatesAShortWay)
{
    InsTrajectory ins{InsOptions{}};
    ins.insert(robotPose(0.0));
    EXPECT_FALSE(ins.at(kStart + 0.05));
    EXPECT_TRUE(ins.at(kStart));
    ins.insert(robotPose(0.1));
    for (const double t : {-0.14, 0.24})
    {
        const auto pose = ins.at(kStart + t);
        ASSERT_TRUE(pose) << t;
        EXPECT_LT((pose->position - Car::fromStart(t)).norm(), 0.1) << t;
        EXPECT_LT(headingError(*pose, t), 1e-3) << t;
    }
    EXPECT_FALSE(ins.at(kStart - 0.16));
    EXPECT_FALSE(ins.at(kStart + 0.26));
}

// Positions in 100 Hz that err by 5 cm, without those between two times.
InsTrajectory noisyAround(double from, double to)
{
    InsTrajectory ins{InsOptions{}};
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.05);
    for (double t = 0.0; t < 30.0; t += 0.01)
    {
        auto pose = robotPose(t);
        pose.pose.mean.x_incr(noise(random));
        pose.pose.mean.y_incr(noise(random));
        if (t <= from || t >= to) ins.insert(pose);
    }
    return ins;
}

TEST(InsTrajectory, CarriesNoNoiseAcrossAGap)
{
    double bridged = 0.0;
    double beyond = 0.0;
    int gaps = 0;
    for (double from = 2.0; from < 28.0; from += 1.0, ++gaps)
    {
        const InsTrajectory ins = noisyAround(from, from + 0.45);
        const InsTrajectory open = noisyAround(from, from + 1.0);
        for (const double t : {from + 0.1, from + 0.225, from + 0.35})
            bridged += (ins.at(kStart + t)->position - Car::fromStart(t)).squaredNorm() / 3.0;
        for (const double t : {from + 0.13, from + 0.87})
            beyond += (open.at(kStart + t)->position - Car::fromStart(t)).squaredNorm() / 2.0;
    }
    // Two coordinates of 5 cm each are 0.07 m. Slopes between neighbours made 0.7 and 1.3 m of
    // them.
    EXPECT_LT(std::sqrt(bridged / gaps), 0.1);
    EXPECT_LT(std::sqrt(beyond / gaps), 0.3);
}

TEST(InsTrajectory, SortsAndDropsDuplicates)
{
    InsTrajectory ins{InsOptions{}};
    for (const int i : {0, 2, 1, 3, 3, 5, 4, 1, 6}) ins.insert(robotPose(0.1 * i));
    EXPECT_EQ(7u, ins.samplesTaken());
    EXPECT_EQ(2u, ins.samplesDropped());
    const auto pose = ins.at(kStart + 0.35);
    ASSERT_TRUE(pose);
    EXPECT_LT((pose->position - Car::fromStart(0.35)).norm(), 1e-3);
}

TEST(InsTrajectory, KnowsWhenWaitingBringsNothing)
{
    InsTrajectory ins{InsOptions{}};
    EXPECT_FALSE(ins.covers(kStart));
    ins.insert(robotPose(1.0));
    EXPECT_TRUE(ins.covers(kStart + 1.0));
    EXPECT_FALSE(ins.covers(kStart + 1.01));
}

TEST(InsTrajectory, WithoutPosesThereIsNone)
{
    InsTrajectory ins{InsOptions{}};
    ins.insert(test::pointCloud(2));
    EXPECT_FALSE(ins.at(kStart));
    EXPECT_EQ("", ins.sourceName());
    EXPECT_EQ("", ins.originText());
    CObservationRobotPose timeless = robotPose(0.0);
    timeless.timestamp = INVALID_TIMESTAMP;
    ins.insert(timeless);
    CObservationRobotPose nowhere = robotPose(0.0);
    nowhere.pose.mean.x(std::nan(""));
    ins.insert(nowhere);
    EXPECT_EQ(0u, ins.samplesTaken());
    EXPECT_EQ(2u, ins.samplesDropped());
}

TEST(InsTrajectory, FollowsOneSensorOnly)
{
    InsTrajectory first{InsOptions{}};
    InsOptions byLabel;
    byLabel.label = "other";
    InsTrajectory named{byLabel};
    for (InsTrajectory* ins : {&first, &named})
    {
        for (int i = 0; i < 5; ++i)
        {
            ins->insert(robotPose(0.1 * i, "ins"));
            ins->insert(robotPose(0.1 * i + 0.05, "other"));
        }
    }
    EXPECT_EQ("CObservationRobotPose 'ins'", first.sourceName());
    EXPECT_EQ("CObservationRobotPose 'other'", named.sourceName());
    EXPECT_EQ(5u, first.samplesTaken());
    EXPECT_EQ(5u, named.samplesTaken());
}

TEST(InsTrajectory, LooksIntoSensoryFrames)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i < 3; ++i)
    {
        mrpt::obs::CSensoryFrame frame;
        frame.insert(CObservationRobotPose::Create(robotPose(0.1 * i)));
        frame.insert(mrpt::obs::CObservationOdometry::Create(test::odometry(i)));
        ins.insert(frame);
    }
    EXPECT_TRUE(ins.at(kStart + 0.15));
}

TEST(InsTrajectory, ForgetsWithoutLosingWhatIsNeeded)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i <= 1000; ++i)
    {
        const double t = 0.1 * i;
        ins.insert(robotPose(t));
        ins.forgetBefore(kStart + t - 0.5);
        if (i < 5) continue;
        const auto pose = ins.at(kStart + t - 0.45);
        ASSERT_TRUE(pose) << t;
        ASSERT_LT((pose->position - Car::fromStart(t - 0.45)).norm(), 1e-3) << t;
    }
    EXPECT_FALSE(ins.at(kStart + 50.0));
}

TEST(InsTrajectory, ForgetsNothingThatTellsOfAGap)
{
    InsTrajectory all = noisyAround(20.0, 20.45);
    InsTrajectory some = noisyAround(20.0, 20.45);
    for (const double t : {20.05, 20.25, 20.4})
    {
        some.forgetBefore(kStart + t);
        EXPECT_EQ(all.at(kStart + t)->position, some.at(kStart + t)->position) << t;
    }
}

}  // namespace
}  // namespace vdamf
