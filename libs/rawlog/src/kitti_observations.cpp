// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_observations.h"

#include <mrpt/maps/CPointsMapXYZI.h>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
// Time of day.
mrpt::obs::gnss::UTC_time utcTime(mrpt::Clock::time_point time)
{
    constexpr std::int64_t kTicksPerMinute = 600'000'000;
    constexpr std::int64_t kTicksPerDay = 864'000'000'000;
    // The clock starts at midnight, and UTC's days have no other length in it.
    const std::int64_t ticks = time.time_since_epoch().count() % kTicksPerDay;
    mrpt::obs::gnss::UTC_time utc;
    utc.hour = static_cast<uint8_t>(ticks / (60 * kTicksPerMinute));
    utc.minute = static_cast<uint8_t>(ticks / kTicksPerMinute % 60);
    utc.sec = static_cast<double>(ticks % kTicksPerMinute) * 1e-7;
    return utc;
}
}  // namespace

mrpt::poses::CPose3D toPose3D(const Eigen::Isometry3d& pose)
{
    return mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(pose.matrix()));
}

mrpt::obs::CObservationRobotPose poseObservation(const Eigen::Isometry3d& vehicleInWorld,
                                                 mrpt::Clock::time_point time)
{
    // What an RT3003 with corrections reaches, and the data set's labels confirm.
    constexpr double kPositionSigma = 0.05;            // m
    constexpr double kAngleSigma = 0.1 * kPi / 180.0;  // rad
    mrpt::obs::CObservationRobotPose observation;
    observation.sensorLabel = "ins";
    observation.timestamp = time;
    observation.pose.mean = toPose3D(vehicleInWorld);
    observation.pose.cov.setZero();
    for (int i = 0; i < 6; ++i)
    {
        const double sigma = i < 3 ? kPositionSigma : kAngleSigma;
        observation.pose.cov(i, i) = sigma * sigma;
    }
    return observation;
}

mrpt::obs::CObservationGPS gpsObservation(const KittiOxts& oxts)
{
    mrpt::obs::gnss::Message_NMEA_GGA gga;
    gga.fields.UTCTime = utcTime(oxts.time);
    gga.fields.latitude_degrees = oxts.latitude;
    gga.fields.longitude_degrees = oxts.longitude;
    gga.fields.altitude_meters = oxts.altitude;
    gga.fields.orthometric_altitude = oxts.altitude;
    gga.fields.corrected_orthometric_altitude = oxts.altitude;
    gga.fields.fix_quality = 1;
    gga.fields.satellitesUsed = static_cast<uint32_t>(oxts.satellites);
    mrpt::obs::CObservationGPS observation;
    observation.sensorLabel = "gps";
    observation.timestamp = oxts.time;
    observation.originalReceivedTimestamp = oxts.time;
    observation.has_satellite_timestamp = true;
    observation.setMsg(gga);
    return observation;
}

mrpt::obs::CObservationPointCloud scanObservation(const PointCloud& scan,
                                                  const Eigen::Isometry3d& sensorInVehicle,
                                                  mrpt::Clock::time_point time)
{
    auto map = mrpt::maps::CPointsMapXYZI::Create();
    map->resize(scan.size());
    for (std::size_t i = 0; i < scan.size(); ++i)
    {
        map->setPointFast(i, scan.x[i], scan.y[i], scan.z[i]);
        map->setPointIntensity(i, scan.intensity[i]);
    }
    map->mark_as_modified();
    mrpt::obs::CObservationPointCloud observation;
    observation.sensorLabel = "velodyne";
    observation.timestamp = time;
    observation.sensorPose = toPose3D(sensorInVehicle);
    observation.pointcloud = map;
    return observation;
}

}  // namespace vdamf
