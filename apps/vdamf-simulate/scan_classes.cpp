// SPDX-License-Identifier: BSD-3-Clause
#include "scan_classes.h"

#include <mrpt/core/Clock.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "native_scans.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservation;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRotatingScan;

const char* nameOf(LadarModel model)
{
    for (const auto& [one, name] : EnumNames<LadarModel>::names())
        if (one == model) return name;
    return "";
}

CObservation::Ptr pointCloud(const SimulatedSensor& sensor, const SimulatedScan& scan)
{
    // Without a place on the vehicle the vehicle's frame is the sensor's.
    const PointCloud points = scanFrom(*nativeScan(sensor, scan))->points;
    auto map = mrpt::maps::CPointsMapXYZI::Create();
    map->resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        map->setPointFast(i, points.x[i], points.y[i], points.z[i]);
        map->setPointIntensity(i, points.intensity[i]);
    }
    map->mark_as_modified();
    const auto observation = std::make_shared<CObservationPointCloud>();
    observation->pointcloud = map;
    return observation;
}

/// Azimuths of the range image, as the class counts them: those of spinning sensors clockwise from
/// the first firing over whole steps, those of line scanners counter-clockwise to the last ray.
void setAngles(CObservationRotatingScan& image, const SimulatedSensor& sensor,
               const SimulatedScan& scan)
{
    const SpinningLadar& ladar = sensor.mount.ladar;
    const Sweep sweep = sweepOf(ladar, sensor.mount.rate, sensor.mount.fieldOfView);
    const auto columns = static_cast<double>(scan.firings.size());
    const bool isLine = ladar.isLineScanner();
    const double first = scan.firings.front().azimuth;
    image.startAzimuth = isLine ? -first : first;
    image.azimuthSpan = std::abs(sweep.azimuthStep) * (isLine ? columns - 1.0 : columns);
    if (!sensor.mount.instantaneous)
        image.sweepDuration = sweep.period * (isLine ? columns - 1.0 : columns);
}

CObservation::Ptr rotatingScan(const SimulatedSensor& sensor, const SimulatedScan& scan)
{
    constexpr double kLargest = 65535.0;
    const SpinningLadar& ladar = sensor.mount.ladar;
    const auto image = std::make_shared<CObservationRotatingScan>();
    const std::size_t rows = ladar.isLineScanner() ? 1 : ladar.elevations.size();
    image->rowCount = static_cast<std::uint16_t>(rows);
    image->columnCount = static_cast<std::uint16_t>(scan.firings.size());
    image->rangeResolution = 0.002;
    image->lidarModel = nameOf(sensor.options.model);
    image->minRange = ladar.minRange;
    image->maxRange = ladar.maxRange;
    image->rangeImage.setZero(image->rowCount, image->columnCount);
    image->intensityImage.setZero(image->rowCount, image->columnCount);
    setAngles(*image, sensor, scan);
    for (std::size_t column = 0; column < scan.firings.size(); ++column)
        for (std::size_t row = 0; row < rows; ++row)
        {
            const LadarReturn& one = scan.firings[column].returns[row];
            const double units = std::round(one.range / image->rangeResolution);
            if (units < 1.0 || units > kLargest) continue;
            const auto r = static_cast<int>(row);
            const auto c = static_cast<int>(column);
            image->rangeImage(r, c) = static_cast<std::uint16_t>(units);
            image->intensityImage(r, c) =
                static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(one.intensity, 0.0, 1.0)));
        }
    return image;
}

CObservation::Ptr inClass(ScanClass scanClass, const SimulatedSensor& sensor,
                          const SimulatedScan& scan)
{
    switch (scanClass)
    {
        case ScanClass::PointCloud:
            return pointCloud(sensor, scan);
        case ScanClass::RotatingScan:
            return rotatingScan(sensor, scan);
        case ScanClass::Native:
            break;
    }
    return nativeScan(sensor, scan);
}
}  // namespace

CObservation::Ptr scanObservation(const Scenario& scenario, const SimulatedScan& scan)
{
    const SimulatedSensor& sensor = scenario.sensors[scan.sensor];
    const LadarMount& mount = sensor.mount;
    const auto observation = inClass(scenario.recording.scanClass, sensor, scan);
    observation->timestamp = mrpt::Clock::fromDouble(scan.time);
    observation->sensorLabel = sensor.label;
    observation->setSensorPose(mrpt::poses::CPose3D(mount.position.x(), mount.position.y(),
                                                    mount.position.z(), mount.heading, mount.pitch,
                                                    mount.roll));
    return observation;
}

}  // namespace vdamf
