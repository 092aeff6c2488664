// SPDX-License-Identifier: BSD-3-Clause
#include "pose_sources.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/topography/conversions.h>

#include <algorithm>
#include <memory>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using namespace mrpt::obs;
using mrpt::topography::TGeodeticCoords;

constexpr double kDegrees = 180.0 / kPi;

TGeodeticCoords geodetic(const Eigen::Vector3d& fromFirst)
{
    const TGeodeticCoords origin(48.5, 9.0, 400.0);
    mrpt::topography::TGeocentricCoords geocentric;
    mrpt::topography::ENUToGeocentric({fromFirst.x(), fromFirst.y(), fromFirst.z()}, origin,
                                      geocentric, mrpt::topography::TEllipsoid::Ellipsoid_WGS84());
    TGeodeticCoords place;
    mrpt::topography::geocentricToGeodetic(geocentric, place);
    return place;
}

mrpt::poses::CPose2D planar(const GroundPose& pose)
{
    return {pose.position.x(), pose.position.y(), pose.heading};
}

CObservation::Ptr robotPose(const InsSample& sample)
{
    constexpr double kPositionVariance = 4e-4;  // m^2
    constexpr double kAngleVariance = 3e-6;     // rad^2
    const GroundPose& pose = sample.pose;
    const auto observation = std::make_shared<CObservationRobotPose>();
    observation->sensorLabel = "ins";
    observation->pose.mean =
        mrpt::poses::CPose3D(pose.position.x(), pose.position.y(), pose.position.z(), pose.heading,
                             pose.pitch, pose.roll);
    observation->pose.cov.setZero();
    const double sigmas[] = {sample.positionSigma, sample.positionSigma, sample.positionSigma,
                             sample.headingSigma,  sample.tiltSigma,     sample.tiltSigma};
    for (int i = 0; i < 6; ++i)
    {
        const double least = i < 3 ? kPositionVariance : kAngleVariance;
        observation->pose.cov(i, i) = std::max(least, sigmas[i] * sigmas[i]);
    }
    return observation;
}

// Novatel counts azimuths clockwise from north, and pitch with the nose up.
CObservation::Ptr inspvas(const TGeodeticCoords& place, const GroundPose& pose)
{
    gnss::Message_NV_OEM6_INSPVAS message;
    message.fields.lat = place.lat.decimal_value;
    message.fields.lon = place.lon.decimal_value;
    message.fields.hgt = place.height;
    const double azimuth = 90.0 - pose.heading * kDegrees;
    message.fields.azimuth = azimuth - 360.0 * std::floor(azimuth / 360.0);
    message.fields.pitch = -pose.pitch * kDegrees;
    message.fields.roll = pose.roll * kDegrees;
    message.fields.ins_status = gnss::nv_oem6_ins_status_type::INS_SOLUTION_GOOD;
    const auto observation = std::make_shared<CObservationGPS>();
    observation->sensorLabel = "ins";
    observation->setMsg(message);
    return observation;
}

CObservation::Ptr gga(const TGeodeticCoords& place)
{
    gnss::Message_NMEA_GGA message;
    message.fields.fix_quality = 4;
    message.fields.satellitesUsed = 12;
    message.fields.latitude_degrees = place.lat.decimal_value;
    message.fields.longitude_degrees = place.lon.decimal_value;
    message.fields.altitude_meters = place.height;
    message.fields.orthometric_altitude = place.height;
    message.fields.corrected_orthometric_altitude = place.height;
    const auto observation = std::make_shared<CObservationGPS>();
    observation->sensorLabel = "gps";
    observation->setMsg(message);
    return observation;
}

CObservation::Ptr imu(const GroundPose& pose)
{
    const auto observation = std::make_shared<CObservationIMU>();
    observation->sensorLabel = "imu";
    observation->set(IMU_YAW, pose.heading);
    observation->set(IMU_PITCH, pose.pitch);
    observation->set(IMU_ROLL, pose.roll);
    return observation;
}

CObservation::Ptr odometry(const GroundPose& pose)
{
    const auto observation = std::make_shared<CObservationOdometry>();
    observation->sensorLabel = "wheels";
    observation->odometry = planar(pose);
    return observation;
}
}  // namespace

mrpt::Clock::time_point PoseRecorder::timeOf(const InsSample& sample) const
{
    return mrpt::Clock::fromDouble(scenario_.run.startTime + sample.sceneTime);
}

std::vector<CObservation::Ptr> PoseRecorder::observations(const InsSample& sample)
{
    if (!first_) first_ = sample.pose;
    const auto place = [&] { return geodetic(sample.pose.position - first_->position); };
    std::vector<CObservation::Ptr> all;
    switch (scenario_.recording.poseSource)
    {
        case PoseSource::RobotPose:
            all = {robotPose(sample)};
            break;
        case PoseSource::Inspvas:
            all = {inspvas(place(), sample.pose)};
            break;
        case PoseSource::Gga:
            all = {gga(place())};
            break;
        case PoseSource::GgaImu:
            all = {imu(sample.pose), gga(place())};
            break;
        case PoseSource::Odometry:
            all = {odometry(sample.pose)};
            break;
        case PoseSource::Actions:
            break;
    }
    for (const auto& observation : all) observation->timestamp = timeOf(sample);
    return all;
}

CActionCollection PoseRecorder::movement(const InsSample& sample)
{
    const mrpt::poses::CPose2D now = planar(sample.pose);
    const mrpt::poses::CPose2D change = last_ ? now - planar(*last_) : mrpt::poses::CPose2D();
    last_ = sample.pose;
    CActionRobotMovement2D action;
    action.computeFromOdometry(change, {});
    action.timestamp = timeOf(sample);
    CActionCollection actions;
    actions.insert(action);
    return actions;
}

}  // namespace vdamf
