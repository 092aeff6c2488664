// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/ins_trajectory.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>

#include "example_objects.h"
#include "sample_rawlogs.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservationGPS;
using mrpt::obs::CObservationRobotPose;

constexpr double kStart = 1.5e9;
constexpr double kSpeed = 14.0;   // m/s
constexpr double kRadius = 40.0;  // m

/// A car on a circle to the left, heading through +-pi. It begins at (kRadius, 0), heading north.
struct Car
{
    static double turned(double t) { return kSpeed / kRadius * t; }
    static Eigen::Vector3d position(double t)
    {
        return {kRadius * std::cos(turned(t)), kRadius * std::sin(turned(t)), 0.1 * t};
    }
    static double heading(double t) { return wrapAngle(turned(t) + kPi / 2.0); }
    /// From where the trajectory has its origin.
    static Eigen::Vector3d fromStart(double t) { return position(t) - position(0.0); }
};

CObservationRobotPose robotPose(double t, const std::string& label = "ins")
{
    CObservationRobotPose observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + t);
    observation.sensorLabel = label;
    const Eigen::Vector3d p = Car::position(t);
    observation.pose.mean = mrpt::poses::CPose3D(p.x(), p.y(), p.z(), Car::heading(t), 0.02, -0.01);
    return observation;
}

/// Degrees and metres on the WGS84 ellipsoid.
struct Geodetic
{
    double latitude = 48.5;
    double longitude = 9.0;
    double height = 400.0;
};

constexpr double kDegree = kPi / 180.0;
constexpr double kEquator = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);

double curvatureRadius(double sine)
{
    return kEquator / std::sqrt(1.0 - kEccentricity2 * sine * sine);
}

/// Geodetic coordinates of a point east, north, up of the default one, by way of geocentric ones.
Geodetic geodetic(const Eigen::Vector3d& enu)
{
    const Geodetic origin;
    const double lat = origin.latitude * kDegree;
    const double lon = origin.longitude * kDegree;
    const double n = curvatureRadius(std::sin(lat));
    Eigen::Matrix3d axes;
    axes.col(0) << -std::sin(lon), std::cos(lon), 0.0;
    axes.col(1) << -std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon), std::cos(lat);
    axes.col(2) << std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat);
    const Eigen::Vector3d centre(0.0, 0.0, -n * kEccentricity2 * std::sin(lat));
    const Eigen::Vector3d p = centre + (n + origin.height) * axes.col(2) + axes * enu;
    const double across = std::hypot(p.x(), p.y());
    double latitude = lat;
    double height = origin.height;
    for (int i = 0; i < 10; ++i)
    {
        const double radius = curvatureRadius(std::sin(latitude));
        height = across / std::cos(latitude) - radius;
        latitude = std::atan2(p.z(), across * (1.0 - kEccentricity2 * radius / (radius + height)));
    }
    return {latitude / kDegree, std::atan2(p.y(), p.x()) / kDegree, height};
}

CObservationGPS gga(double t, const Eigen::Vector3d& enu)
{
    CObservationGPS observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + t);
    observation.sensorLabel = "gps";
    mrpt::obs::gnss::Message_NMEA_GGA message;
    const Geodetic place = geodetic(enu);
    message.fields.fix_quality = 4;
    message.fields.latitude_degrees = place.latitude;
    message.fields.longitude_degrees = place.longitude;
    message.fields.altitude_meters = place.height;
    observation.setMsg(message);
    return observation;
}

CObservationGPS inspvas(double t)
{
    CObservationGPS observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + t);
    observation.sensorLabel = "span";
    mrpt::obs::gnss::Message_NV_OEM6_INSPVAS message;
    const Geodetic place = geodetic(Car::position(t));
    message.fields.lat = place.latitude;
    message.fields.lon = place.longitude;
    message.fields.hgt = place.height;
    message.fields.azimuth = 90.0 - Car::heading(t) * 180.0 / kPi;
    message.fields.pitch = 3.0;  // nose up
    message.fields.roll = 2.0;   // right side down
    message.fields.ins_status = mrpt::obs::gnss::nv_oem6_ins_status_type::INS_SOLUTION_GOOD;
    observation.setMsg(message);
    return observation;
}

double headingOf(const VehiclePose& pose)
{
    const Eigen::Vector3d forward = pose.attitude * Eigen::Vector3d::UnitX();
    return std::atan2(forward.y(), forward.x());
}

double headingError(const VehiclePose& pose, double t)
{
    return std::abs(wrapAngle(headingOf(pose) - Car::heading(t)));
}

InsOptions from(InsSource source)
{
    InsOptions options;
    options.source = source;
    return options;
}

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
    ins.insert(test::odometry(0));
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

TEST(InsTrajectory, AutoFixesItsSourceAtTheFirstQuestion)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i < 5; ++i) ins.insert(inspvas(0.1 * i));
    EXPECT_TRUE(ins.at(kStart + 0.2));
    for (int i = 0; i < 5; ++i) ins.insert(robotPose(0.1 * i));
    EXPECT_EQ("CObservationGPS (INSPVAS) 'span'", ins.sourceName());

    InsTrajectory other{InsOptions{}};
    for (int i = 0; i < 5; ++i) other.insert(inspvas(0.1 * i));
    for (int i = 0; i < 5; ++i) other.insert(robotPose(0.1 * i));
    EXPECT_TRUE(other.at(kStart + 0.2));
    EXPECT_EQ("CObservationRobotPose 'ins'", other.sourceName());
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

TEST(InsTrajectory, InspvasGivesPositionAndAttitude)
{
    InsTrajectory ins{from(InsSource::Gps)};
    for (int i = 0; i <= 100; ++i)
    {
        CObservationGPS observation = inspvas(0.1 * i);
        if (i == 7)
        {
            observation.getMsgByClass<mrpt::obs::gnss::Message_NV_OEM6_INSPVAS>()
                .fields.ins_status = mrpt::obs::gnss::nv_oem6_ins_status_type::INS_ALIGNING;
        }
        ins.insert(observation);
    }
    EXPECT_EQ(1u, ins.samplesDropped());
    for (const double t : {0.0, 2.34, 9.99})
    {
        const auto pose = ins.at(kStart + t);
        ASSERT_TRUE(pose);
        // The world's axes are those at the first position, 40 m east of the test's own.
        EXPECT_LT((pose->position - Car::fromStart(t)).norm(), 2e-3) << t;
        EXPECT_LT(headingError(*pose, t), 1e-4);
        EXPECT_NEAR(std::sin(3.0 * kPi / 180.0), (pose->attitude * Eigen::Vector3d::UnitX()).z(),
                    1e-6);
        EXPECT_LT((pose->attitude * -Eigen::Vector3d::UnitY()).z(), -0.03);
    }
    EXPECT_EQ(0u, ins.originText().find("latitude 48.4999"));
}

TEST(InsTrajectory, PositionsAloneTakeTheCourse)
{
    InsTrajectory ins{from(InsSource::Gps)};
    for (int i = 0; i <= 100; ++i)
    {
        CObservationGPS observation = gga(0.1 * i, Car::position(0.1 * i));
        observation.sensorPose = mrpt::poses::CPose3D(0.0, 0.0, 1.5, 0.0, 0.0, 0.0);
        ins.insert(observation);
    }
    EXPECT_EQ("CObservationGPS (GGA) 'gps'", ins.sourceName());
    for (double t = 0.2; t < 9.8; t += 0.037)
    {
        const auto pose = ins.at(kStart + t);
        ASSERT_TRUE(pose);
        const Eigen::Vector3d expected = Car::fromStart(t) - Eigen::Vector3d(0.0, 0.0, 1.5);
        EXPECT_LT((pose->position - expected).norm(), 5e-3) << t;
        EXPECT_LT(headingError(*pose, t), 1e-3) << t;
    }
    // At the newest sample the course is that of the last stretch.
    EXPECT_LT(headingError(*ins.at(kStart + 10.0), 10.0), 0.02);
}

TEST(InsTrajectory, KeepsTheCourseAtStandstill)
{
    InsTrajectory ins{from(InsSource::Gps)};
    ins.insert(gga(0.0, Eigen::Vector3d::Zero()));
    EXPECT_FALSE(ins.at(kStart)) << "the heading is not known yet";
    // Stands, drives to the north-west for a second, stands for ten.
    double t = 0.0;
    double driven = 0.0;
    for (int i = 1; i < 130; ++i)
    {
        t = 0.1 * i;
        if (i > 10 && i <= 20) driven += 0.8;
        const Eigen::Vector3d jitter(0.01 * (i % 3), -0.01 * (i % 2), 0.0);
        ins.insert(gga(t, Eigen::Vector3d(-driven, driven, 0.0) + jitter));
        ins.forgetBefore(kStart + t - 1.0);
    }
    const auto pose = ins.at(kStart + t - 0.05);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(0.75 * kPi, headingOf(*pose), 0.05);
    EXPECT_NEAR(-8.0, pose->position.x(), 0.05);
}

TEST(InsTrajectory, TakesTheBestThatAReceiverSends)
{
    InsTrajectory ins{from(InsSource::Gps)};
    for (int i = 0; i < 20; ++i)
    {
        ins.insert(gga(0.1 * i, Car::position(0.1 * i)));
        CObservationGPS better = inspvas(0.1 * i + 0.05);
        better.sensorLabel = "gps";
        ins.insert(better);
    }
    EXPECT_EQ("CObservationGPS (INSPVAS) 'gps'", ins.sourceName());
    EXPECT_EQ(20u, ins.samplesTaken());
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

TEST(InsTrajectory, ReadsRecordedGps)
{
    const auto path = test::sampleRawlog("test_rtk_path.rawlog");
    if (path.empty()) GTEST_SKIP() << test::whereSamplesAre();
    InsOptions options;
    options.label = "GPS_RTK_FRONT_L";
    InsTrajectory ins{options};
    RawlogReader reader(path);
    double last = 0.0;
    for (const RawlogEntry& entry : test::entriesOf(reader))
    {
        if (!entry.object) continue;
        ins.insert(*entry.object);
        const auto gps = std::dynamic_pointer_cast<CObservationGPS>(entry.object);
        if (gps) last = mrpt::Clock::toDouble(gps->timestamp);
    }
    EXPECT_EQ("CObservationGPS (GGA) 'GPS_RTK_FRONT_L'", ins.sourceName());
    EXPECT_EQ(307u, ins.samplesTaken());
    EXPECT_TRUE(ins.at(last - 10.0));
}

}  // namespace
}  // namespace vdamf
