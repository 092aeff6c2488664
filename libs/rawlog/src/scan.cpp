// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/scan.h"

#include <mrpt/core/Clock.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "object_parser.h"
#include "range_camera.h"
#include "rotating_scan.h"
#include "timed_points_map.h"
#include "vdamf/rawlog/allocation_limit.h"
#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRotatingScan;
using mrpt::obs::CObservationVelodyneScan;

/// The points of an observation that keeps them in a file of their own, which stays as it is.
class ExternalCloud : public CObservationPointCloud
{
public:
    ExternalCloud(const CObservationPointCloud& observation, const ExternalFiles& files)
        : CObservationPointCloud(observation)
    {
        m_external_file = files.find(m_external_file).string();
        const AllocationLimit limit(ExternalFiles::kLargestAllocation);
        load();
    }
};

/// MRPT does not say which range intensities have; what is above 1 is 0..255.
void bytesToOne(std::vector<float>& intensity)
{
    const auto above = [](float value) { return value > 1.0F; };
    if (std::none_of(intensity.begin(), intensity.end(), above)) return;
    for (float& value : intensity) value /= 255.0F;
}

PointCloud pointsOf(const mrpt::maps::CPointsMap& map)
{
    PointCloud cloud;
    cloud.x.assign(map.getPointsBufferRef_x().begin(), map.getPointsBufferRef_x().end());
    cloud.y.assign(map.getPointsBufferRef_y().begin(), map.getPointsBufferRef_y().end());
    cloud.z.assign(map.getPointsBufferRef_z().begin(), map.getPointsBufferRef_z().end());
    const auto* const timed = dynamic_cast<const TimedPointsMap*>(&map);
    if (timed != nullptr) cloud.time = timed->times();
    if (timed != nullptr && !timed->hasIntensities()) return cloud;
    if (const auto* withIntensity = dynamic_cast<const mrpt::maps::CPointsMapXYZI*>(&map))
    {
        cloud.intensity.reserve(cloud.size());
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            cloud.intensity.push_back(withIntensity->getPointIntensity_fast(i));
        }
        bytesToOne(cloud.intensity);
    }
    return cloud;
}

PointCloud cloudOf(const CObservationPointCloud& observation, const ExternalFiles& files)
{
    if (observation.pointcloud) return pointsOf(*observation.pointcloud);
    if (!observation.isExternallyStored()) throw std::runtime_error("it has no point cloud");
    const ExternalCloud external(observation, files);
    if (!external.pointcloud) throw std::runtime_error("its external file holds no point cloud");
    return pointsOf(*external.pointcloud);
}

PointCloud raysOf(const CObservation2DRangeScan& line)
{
    PointCloud cloud;
    for (std::size_t i = 0; i < line.getScanSize(); ++i)
    {
        const float range = line.getScanRange(i);
        if (!line.getScanRangeValidity(i) || !(range > 0.0F && range < line.maxRange)) continue;
        const float angle = line.getScanSize() > 1 ? line.getScanAngle(i) : 0.0F;
        cloud.x.push_back(range * std::cos(angle));
        cloud.y.push_back(range * std::sin(angle));
        cloud.z.push_back(0.0F);
        if (line.hasIntensity())
            cloud.intensity.push_back(static_cast<float>(line.getScanIntensity(i)));
    }
    bytesToOne(cloud.intensity);
    return cloud;
}

/// Whether the plane of the rays is level, either way up.
bool isLevel(const mrpt::poses::CPose3D& sensorPose)
{
    constexpr double kCosine = 0.99939;  // of 2 degrees
    return std::abs(sensorPose.getRotationMatrix()(2, 2)) > kCosine;
}

/// Sensors without a return at a point write zeros or NaN.
bool isReturn(float x, float y, float z)
{
    return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) &&
           (x != 0.0F || y != 0.0F || z != 0.0F);
}

/// Moves the returns from the sensor's frame to the vehicle's, and drops what is none.
PointCloud returnsInVehicle(PointCloud cloud, const mrpt::poses::CPose3D& sensorPose)
{
    const Eigen::Matrix3d r = sensorPose.getRotationMatrix().asEigen();
    const Eigen::Vector3d t(sensorPose.x(), sensorPose.y(), sensorPose.z());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        if (!isReturn(cloud.x[i], cloud.y[i], cloud.z[i])) continue;
        const Eigen::Vector3d inSensor(cloud.x[i], cloud.y[i], cloud.z[i]);
        const Eigen::Vector3f p = (r * inSensor + t).cast<float>();
        cloud.x[kept] = p.x();
        cloud.y[kept] = p.y();
        cloud.z[kept] = p.z();
        if (!cloud.intensity.empty()) cloud.intensity[kept] = cloud.intensity[i];
        if (!cloud.time.empty()) cloud.time[kept] = cloud.time[i];
        ++kept;
    }
    for (auto* values : {&cloud.x, &cloud.y, &cloud.z, &cloud.intensity, &cloud.time})
    {
        if (!values->empty()) values->resize(kept);
    }
    return cloud;
}

bool isFinite(const mrpt::poses::CPose3D& pose)
{
    return std::isfinite(pose.x() + pose.y() + pose.z() + pose.yaw() + pose.pitch() + pose.roll());
}

Scan scanOf(const mrpt::obs::CObservation& observation, PointCloud cloud)
{
    if (observation.timestamp == INVALID_TIMESTAMP) throw std::runtime_error("it has no time");
    const mrpt::poses::CPose3D sensorPose(observation.sensorPose());
    if (!isFinite(sensorPose)) throw std::runtime_error("its sensor pose is not finite");
    Scan scan;
    scan.time = mrpt::Clock::toDouble(observation.timestamp);
    scan.sensorLabel = observation.sensorLabel;
    scan.sensorInVehicle = {sensorPose.x(), sensorPose.y(), sensorPose.z()};
    scan.points = returnsInVehicle(std::move(cloud), sensorPose);
    scan.planar = isLineScan(observation) && isLevel(sensorPose);
    return scan;
}
}  // namespace

bool isScan(const mrpt::obs::CObservation& observation)
{
    return dynamic_cast<const CObservationPointCloud*>(&observation) != nullptr ||
           dynamic_cast<const CObservationVelodyneScan*>(&observation) != nullptr ||
           dynamic_cast<const CObservationRotatingScan*>(&observation) != nullptr ||
           dynamic_cast<const CObservation3DRangeScan*>(&observation) != nullptr ||
           isLineScan(observation);
}

bool isLineScan(const mrpt::obs::CObservation& observation)
{
    const auto* rotating = dynamic_cast<const CObservationRotatingScan*>(&observation);
    return dynamic_cast<const CObservation2DRangeScan*>(&observation) != nullptr ||
           (rotating != nullptr && rotating->rangeImage.rows() == 1);
}

bool isMinorScan(const mrpt::obs::CObservation& observation)
{
    return isLineScan(observation) ||
           dynamic_cast<const CObservation3DRangeScan*>(&observation) != nullptr;
}

double durationOf(const mrpt::obs::CObservation& observation)
{
    constexpr double kLongest = 1.0;
    if (const auto* velodyne = dynamic_cast<const CObservationVelodyneScan*>(&observation))
        return durationOf(*velodyne);
    if (const auto* rotating = dynamic_cast<const CObservationRotatingScan*>(&observation))
        return rotating->sweepDuration > 0.0 ? std::min(rotating->sweepDuration, kLongest) : 0.0;
    const auto* cloud = dynamic_cast<const CObservationPointCloud*>(&observation);
    if (cloud != nullptr)
    {
        const auto* timed = dynamic_cast<const TimedPointsMap*>(cloud->pointcloud.get());
        double last = 0.0;
        if (timed != nullptr)
            for (const float time : timed->times()) last = std::max(last, double{time});
        return std::min(last, kLongest);
    }
    return 0.0;
}

std::optional<Scan> scanFrom(const mrpt::obs::CObservation& observation, const ExternalFiles& files)
{
    try
    {
        if (const auto* cloud = dynamic_cast<const CObservationPointCloud*>(&observation))
        {
            return scanOf(observation, cloudOf(*cloud, files));
        }
        if (const auto* velodyne = dynamic_cast<const CObservationVelodyneScan*>(&observation))
        {
            return scanOf(observation, decodeVelodyne(*velodyne));
        }
        if (const auto* line = dynamic_cast<const CObservation2DRangeScan*>(&observation))
        {
            return scanOf(observation, raysOf(*line));
        }
        if (const auto* rotating = dynamic_cast<const CObservationRotatingScan*>(&observation))
        {
            return scanOf(observation, hitsOf(*rotating));
        }
        if (const auto* camera = dynamic_cast<const CObservation3DRangeScan*>(&observation))
        {
            return scanOf(observation, hitsOf(*camera, files));
        }
        return std::nullopt;
    }
    catch (const std::exception& error)
    {
        throw std::runtime_error(std::string(observation.GetRuntimeClass()->className) + " '" +
                                 observation.sensorLabel + "': " + shortMessage(error.what()));
    }
}

}  // namespace vdamf
