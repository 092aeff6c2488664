// SPDX-License-Identifier: BSD-3-Clause
// Trajectories from odometry, from actions, from GPS with an IMU, and of what stands still.
#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include "../files/temporary_folder.h"
#include "example_car.h"
#include "example_objects.h"

namespace vdamf
{
namespace
{
using mrpt::poses::CPose2D;
using Movement = mrpt::obs::CActionRobotMovement2D;
using test::Car;
using test::headingError;
using test::headingOf;
using test::insFrom;
using test::kStart;
using test::robotPose;

CPose2D planarPose(double t)
{
    const Eigen::Vector3d p = Car::position(t);
    return {p.x(), p.y(), Car::heading(t)};
}

mrpt::obs::CObservationOdometry odometry(double t)
{
    mrpt::obs::CObservationOdometry observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + t);
    observation.sensorLabel = "wheels";
    observation.odometry = planarPose(t);
    return observation;
}

/// Of the car, at a latitude where metres are easily made degrees (good to 0.1 % near the origin).
mrpt::obs::CObservationGPS gps(double t, double x, double y)
{
    constexpr double kMetresPerDegree = 111319.49;
    mrpt::obs::gnss::Message_NMEA_GGA message;
    message.fields.fix_quality = 4;
    message.fields.latitude_degrees = y / 110574.28;
    message.fields.longitude_degrees = x / kMetresPerDegree;
    mrpt::obs::CObservationGPS observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + t);
    observation.sensorLabel = "gps";
    observation.setMsg(message);
    return observation;
}

mrpt::obs::CObservationIMU imu(double t, double yaw)
{
    mrpt::obs::CObservationIMU observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + t);
    observation.sensorLabel = "xsens";
    observation.set(mrpt::obs::IMU_YAW, yaw);
    return observation;
}

TEST(InsSources, OdometryGivesPlanarPoses)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i <= 100; ++i) ins.insert(odometry(0.1 * i));
    const auto pose = ins.at(kStart + 4.23);
    ASSERT_TRUE(pose);
    // Axes of the odometry, origin at its first pose: here rotated by the car's first heading.
    const Eigen::Vector3d way = Car::fromStart(4.23);
    EXPECT_NEAR(pose->position.head<2>().norm(), way.head<2>().norm(), 0.01);
    EXPECT_NEAR(pose->position.z(), 0.0, 1e-12);
    EXPECT_LT(headingError(*pose, 4.23), 1e-3);
    EXPECT_EQ(ins.sourceName(), "CObservationOdometry 'wheels'");
}

TEST(InsSources, AutoTakesOdometryOnlyWhereNothingBetterIs)
{
    InsTrajectory ins{InsOptions{}};
    ins.insert(odometry(0.0));
    ins.insert(odometry(0.1));
    ins.insert(robotPose(0.0));
    ins.insert(robotPose(0.1));
    ASSERT_TRUE(ins.at(kStart + 0.05));
    EXPECT_EQ(ins.sourceName(), "CObservationRobotPose 'ins'");
    InsTrajectory wheels{insFrom(InsSource::Odometry)};
    wheels.insert(robotPose(0.0));
    wheels.insert(odometry(0.0));
    EXPECT_EQ(wheels.sourceName(), "CObservationOdometry 'wheels'");
}

TEST(InsSources, StandingNeedsNoObservation)
{
    InsTrajectory ins{insFrom(InsSource::Standing)};
    ins.insert(robotPose(0.0));
    const auto pose = ins.at(kStart + 5.0);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->time, kStart + 5.0);
    EXPECT_TRUE(pose->position.isZero());
    EXPECT_TRUE(ins.covers(1e12));
    EXPECT_EQ(ins.sourceName(), "none, standing");
}

class InsFromActions : public TemporaryFolder
{
protected:
    /// Feeds a rawlog of actions, each before its frame, to a trajectory.
    InsTrajectory read(const std::string& bytes)
    {
        RawlogReader reader(make("a.rawlog", bytes));
        InsTrajectory ins{InsOptions{}};
        for (const RawlogEntry& entry : test::entriesOf(reader))
        {
            if (entry.movement) ins.insert(*entry.movement);
            if (entry.object) ins.insert(*entry.object);
        }
        return ins;
    }
};

std::string collection(mrpt::obs::CAction& action)
{
    mrpt::obs::CActionCollection actions;
    actions.insert(action);
    return serialized(actions);
}

std::string byOdometry(double t, bool stamped)
{
    Movement::TMotionModelOptions model;
    Movement action;
    const CPose2D change = t > 0.0 ? planarPose(t) - planarPose(t - 0.1) : CPose2D();
    action.computeFromOdometry(change, model);
    action.timestamp = stamped ? mrpt::Clock::fromDouble(kStart + t) : INVALID_TIMESTAMP;
    return collection(action);
}

TEST_F(InsFromActions, ChainTheirMovements)
{
    for (const bool stamped : {true, false})
    {
        std::string bytes;
        for (int i = 0; i <= 100; ++i)
            bytes +=
                byOdometry(0.1 * i, stamped) + serialized(test::pointCloud(3, kStart + 0.1 * i));
        const InsTrajectory ins = read(bytes);
        EXPECT_EQ(ins.sourceName(), "CActionCollection");
        EXPECT_EQ(ins.samplesTaken(), 101U);
        const auto pose = ins.at(kStart + 6.0);
        ASSERT_TRUE(pose);
        const CPose2D expected = planarPose(6.0) - planarPose(0.0);
        EXPECT_NEAR(pose->position.x(), expected.x(), 1e-6);
        EXPECT_NEAR(pose->position.y(), expected.y(), 1e-6);
        EXPECT_NEAR(std::abs(wrapAngle(headingOf(*pose) - expected.phi())), 0.0, 1e-6);
    }
}

TEST_F(InsFromActions, TakeGaussiansAndMovementsInSpace)
{
    mrpt::poses::CPosePDFGaussian pdf;
    pdf.mean = CPose2D(1.0, 0.5, 0.1);
    Movement byScans;
    byScans.poseChange = mrpt::poses::CPosePDFGaussian::Create(pdf);
    byScans.estimationMethod = Movement::emScan2DMatching;
    byScans.timestamp = mrpt::Clock::fromDouble(kStart);
    mrpt::obs::CActionRobotMovement3D inSpace;
    inSpace.poseChange.mean = mrpt::poses::CPose3D(2.0, 0.0, 0.25, 0.0, 0.1, 0.0);
    inSpace.timestamp = mrpt::Clock::fromDouble(kStart + 0.2);
    const std::string cloud = serialized(test::pointCloud(3));
    RawlogReader reader(make("a.rawlog", collection(byScans) + cloud + serialized(byScans) + cloud +
                                             collection(inSpace)));
    auto entries = test::entriesOf(reader);
    ASSERT_EQ(entries.size(), 5U);
    entries.erase(entries.begin() + 3);
    entries.erase(entries.begin() + 1);
    for (std::size_t i = 0; i < 2; ++i)
    {
        ASSERT_TRUE(entries[i].movement) << i;
        EXPECT_NEAR(entries[i].movement->change.translation().y(), 0.5, 1e-12);
        EXPECT_NEAR(entries[i].movement->time.value_or(0.0), kStart, 1e-6);
    }
    ASSERT_TRUE(entries[2].movement);
    EXPECT_NEAR(entries[2].movement->change.translation().z(), 0.25, 1e-12);
    EXPECT_NEAR(entries[2].movement->change(2, 0), -std::sin(0.1), 1e-12);
    EXPECT_NEAR(entries[2].movement->time.value_or(0.0), kStart + 0.2, 1e-6);
}

TEST_F(InsFromActions, ThatAreCutOrEmptyTellNothing)
{
    mrpt::obs::CActionCollection none;
    RawlogReader reader(make("a.rawlog", serialized(none)));
    const auto entries = test::entriesOf(reader);
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_FALSE(entries[0].movement);
}

TEST(InsFromImu, TurnsPositionsIntoPoses)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i <= 50; ++i)
    {
        // Sideways: the course would say north.
        ins.insert(gps(0.1 * i, 0.0, 0.5 * i));
        ins.insert(imu(0.1 * i + 0.03, 0.7));
    }
    const auto pose = ins.at(kStart + 2.05);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(headingOf(*pose), 0.7, 1e-6);
    EXPECT_NEAR(pose->position.y(), 10.25, 0.01);
    EXPECT_EQ(ins.sourceName(), "CObservationGPS (GGA) 'gps' with CObservationIMU 'xsens'");
    ASSERT_TRUE(ins.report().imuLessCourse);
    EXPECT_NEAR(*ins.report().imuLessCourse, 0.7 - kPi / 2.0, 0.01);
}

TEST(InsFromImu, HonoursOffsetMountingAndLabel)
{
    InsOptions options;
    options.imuYawOffset = kPi / 2.0;
    options.imuLabel = "xsens";
    InsTrajectory ins{options};
    for (int i = 0; i <= 5; ++i)
    {
        ins.insert(gps(0.1 * i, 0.0, 0.0));
        auto other = imu(0.1 * i, 3.0);
        other.sensorLabel = "phone";
        ins.insert(other);
        auto one = imu(0.1 * i, 0.2);
        one.sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0.1, 0, 0);
        ins.insert(one);
    }
    const auto pose = ins.at(kStart + 0.25);
    ASSERT_TRUE(pose) << "a standing vehicle has a heading from its IMU";
    EXPECT_NEAR(headingOf(*pose), kPi / 2.0 + 0.1, 1e-9);
}

TEST(InsFromImu, CourseOrNothingWhereAsked)
{
    InsOptions options;
    options.gpsHeading = GpsHeading::Course;
    InsTrajectory course{options};
    options.gpsHeading = GpsHeading::Imu;
    InsTrajectory needsImu{options};
    for (int i = 0; i <= 20; ++i)
    {
        course.insert(gps(0.1 * i, 0.0, 0.5 * i));
        course.insert(imu(0.1 * i, 0.7));
        needsImu.insert(gps(0.1 * i, 0.0, 0.5 * i));
    }
    ASSERT_TRUE(course.at(kStart + 1.0));
    EXPECT_NEAR(headingOf(*course.at(kStart + 1.0)), kPi / 2.0, 1e-3);
    EXPECT_FALSE(needsImu.at(kStart + 1.0));
}

}  // namespace
}  // namespace vdamf
