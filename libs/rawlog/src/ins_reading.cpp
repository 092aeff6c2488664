// SPDX-License-Identifier: BSD-3-Clause
#include "ins_reading.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservationGPS;
using mrpt::obs::CObservationRobotPose;
using mrpt::obs::gnss::Message_NMEA_GGA;
using mrpt::obs::gnss::Message_NMEA_RMC;
using mrpt::obs::gnss::Message_NV_OEM6_INSPVAS;
using mrpt::topography::TGeodeticCoords;

Eigen::Quaterniond attitudeFrom(double yaw, double pitch, double roll)
{
    return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

Eigen::Isometry3d isometry(const mrpt::poses::CPose3D& pose)
{
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = pose.getRotationMatrix().asEigen();
    result.translation() = Eigen::Vector3d(pose.x(), pose.y(), pose.z());
    return result;
}

bool isPlace(double latitude, double longitude, double height)
{
    return std::abs(latitude) <= 90.0 && std::abs(longitude) <= 360.0 && std::isfinite(height);
}

InsReading fromRobotPose(const CObservationRobotPose& observation)
{
    const mrpt::poses::CPose3D& mean = observation.pose.mean;
    InsReading reading;
    reading.grade = InsReading::Grade::RobotPose;
    reading.sample.position = {mean.x(), mean.y(), mean.z()};
    reading.sample.attitude = Eigen::Quaterniond(isometry(mean).linear());
    reading.sensorInVehicle = isometry(observation.sensorPose);
    reading.valid =
        reading.sample.position.allFinite() && reading.sample.attitude->coeffs().allFinite();
    return reading;
}

InsReading fromOdometry(const mrpt::obs::CObservationOdometry& observation)
{
    const mrpt::poses::CPose2D& pose = observation.odometry;
    InsReading reading;
    reading.grade = InsReading::Grade::Odometry;
    reading.sample.position = {pose.x(), pose.y(), 0.0};
    reading.sample.attitude = attitudeFrom(pose.phi(), 0.0, 0.0);
    reading.valid = std::isfinite(pose.x() + pose.y() + pose.phi());
    return reading;
}

// Novatel: azimuth clockwise from north, pitch positive with the nose up, roll positive with the
// right side down. MRPT's pitch turns about the left axis: positive with the nose down.
InsReading fromInspvas(const Message_NV_OEM6_INSPVAS& message)
{
    const auto& fields = message.fields;
    const double yaw = kPi / 2.0 - fields.azimuth * kDegree;
    InsReading reading;
    reading.grade = InsReading::Grade::Inspvas;
    reading.geodetic = TGeodeticCoords(fields.lat, fields.lon, fields.hgt);
    reading.sample.attitude = attitudeFrom(yaw, -fields.pitch * kDegree, fields.roll * kDegree);
    // Without alignment the fields are zero or the attitude is arbitrary. Programs that convert
    // other INS to this message leave the status at its default, INS_INACTIVE.
    const bool aligning =
        fields.ins_status == mrpt::obs::gnss::nv_oem6_ins_status_type::INS_ALIGNING;
    const bool nowhere = fields.lat == 0.0 && fields.lon == 0.0;
    reading.valid = !aligning && !nowhere && isPlace(fields.lat, fields.lon, fields.hgt) &&
                    reading.sample.attitude->coeffs().allFinite();
    return reading;
}

InsReading fromGga(const Message_NMEA_GGA& message)
{
    const auto& fields = message.fields;
    InsReading reading;
    reading.grade = InsReading::Grade::Gga;
    reading.geodetic = message.getAsStruct<TGeodeticCoords>();
    reading.valid =
        fields.fix_quality != 0 &&
        isPlace(fields.latitude_degrees, fields.longitude_degrees, fields.altitude_meters);
    return reading;
}

InsReading fromRmc(const Message_NMEA_RMC& message)
{
    const auto& fields = message.fields;
    InsReading reading;
    reading.grade = InsReading::Grade::Rmc;
    reading.geodetic = TGeodeticCoords(fields.latitude_degrees, fields.longitude_degrees, 0.0);
    reading.valid = fields.validity_char == 'A' &&
                    isPlace(fields.latitude_degrees, fields.longitude_degrees, 0.0);
    return reading;
}

std::optional<InsReading> fromGps(const CObservationGPS& observation)
{
    std::optional<InsReading> reading;
    if (observation.hasMsgClass<Message_NV_OEM6_INSPVAS>())
    {
        reading = fromInspvas(observation.getMsgByClass<Message_NV_OEM6_INSPVAS>());
    }
    else if (observation.hasMsgClass<Message_NMEA_GGA>())
    {
        reading = fromGga(observation.getMsgByClass<Message_NMEA_GGA>());
    }
    else if (observation.hasMsgClass<Message_NMEA_RMC>())
    {
        reading = fromRmc(observation.getMsgByClass<Message_NMEA_RMC>());
    }
    if (reading) reading->sensorInVehicle = isometry(observation.sensorPose);
    return reading;
}
}  // namespace

std::optional<InsReading> insReading(const mrpt::obs::CObservation& observation)
{
    std::optional<InsReading> reading;
    if (const auto* pose = dynamic_cast<const CObservationRobotPose*>(&observation))
    {
        reading = fromRobotPose(*pose);
    }
    else if (const auto* gps = dynamic_cast<const CObservationGPS*>(&observation))
    {
        reading = fromGps(*gps);
    }
    else if (const auto* wheels =
                 dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation))
    {
        reading = fromOdometry(*wheels);
    }
    if (!reading) return std::nullopt;
    const bool stamped = observation.timestamp != INVALID_TIMESTAMP;
    if (stamped) reading->sample.time = mrpt::Clock::toDouble(observation.timestamp);
    reading->valid = reading->valid && stamped && reading->sensorInVehicle.matrix().allFinite();
    return reading;
}

std::string nameOf(InsReading::Grade grade)
{
    switch (grade)
    {
        case InsReading::Grade::Rmc:
            return "CObservationGPS (RMC)";
        case InsReading::Grade::Gga:
            return "CObservationGPS (GGA)";
        case InsReading::Grade::Inspvas:
            return "CObservationGPS (INSPVAS)";
        case InsReading::Grade::Odometry:
            return "CObservationOdometry";
        case InsReading::Grade::Movement:
            return "CActionCollection";
        case InsReading::Grade::RobotPose:
            return "CObservationRobotPose";
    }
    return {};
}

}  // namespace vdamf
