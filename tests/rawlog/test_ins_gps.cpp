// SPDX-License-Identifier: BSD-3-Clause
// Trajectories from GPS receivers, with and without attitude.
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationGPS.h>

#include <cmath>

#include "example_car.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservationGPS;
using test::Car;
using test::headingError;
using test::headingOf;
using test::insFrom;
using test::kStart;
using test::robotPose;

/// Degrees and metres on the WGS84 ellipsoid.
struct Geodetic
{
    double latitude = 48.5;
    double longitude = 9.0;
    double height = 400.0;
};

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

TEST(InsFromGps, InspvasGivesPositionAndAttitude)
{
    InsTrajectory ins{insFrom(InsSource::Gps)};
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

TEST(InsFromGps, PositionsAloneTakeTheCourse)
{
    InsTrajectory ins{insFrom(InsSource::Gps)};
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

TEST(InsFromGps, KeepsTheCourseAtStandstill)
{
    InsTrajectory ins{insFrom(InsSource::Gps)};
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

TEST(InsFromGps, TakesTheBestThatAReceiverSends)
{
    InsTrajectory ins{insFrom(InsSource::Gps)};
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

TEST(InsFromGps, AutoFixesItsSourceAtTheFirstQuestion)
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

}  // namespace
}  // namespace vdamf
