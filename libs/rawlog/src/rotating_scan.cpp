// SPDX-License-Identifier: BSD-3-Clause
#include "rotating_scan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "velodyne_layout.h"

namespace vdamf
{
namespace
{
using RotatingScan = mrpt::obs::CObservationRotatingScan;

/// How the cells of a range image lie in the sensor's frame and in time.
struct ImageGeometry
{
    std::vector<double> elevations;  ///< of the rows, rad
    std::vector<double> delays;      ///< of the rows' shots in their column, s
    double firstAzimuth = 0.0;       ///< counter-clockwise, rad
    double azimuthStep = 0.0;        ///< from column to column, rad
    double period = 0.0;             ///< from column to column, s; 0: not known
};

ImageGeometry lineGeometry(const RotatingScan& scan)
{
    const double steps = std::max(1.0, static_cast<double>(scan.rangeImage.cols() - 1));
    return {{0.0}, {0.0}, scan.startAzimuth, scan.azimuthSpan / steps, scan.sweepDuration / steps};
}

int lastColumnWithHits(const RotatingScan& scan)
{
    for (auto column = scan.rangeImage.cols() - 1; column >= 0; --column)
        for (int row = 0; row < scan.rangeImage.rows(); ++row)
            if (scan.rangeImage(row, column) != 0) return static_cast<int>(column);
    return 0;
}

ImageGeometry velodyneGeometry(const RotatingScan& scan, VelodyneModel model)
{
    ImageGeometry geometry;
    geometry.elevations = laserElevations(model);
    const auto lasers = static_cast<int>(geometry.elevations.size());
    const auto all = static_cast<int>(scan.rangeImage.cols());
    const bool tooMany = lastColumnWithHits(scan) < all / lasers;
    const double columns = std::max(1, tooMany ? all / lasers : all);
    geometry.firstAzimuth = -scan.startAzimuth;
    geometry.azimuthStep = -std::abs(scan.azimuthSpan) / columns;
    geometry.period = scan.sweepDuration / columns;
    for (int laser = 0; laser < lasers; ++laser)
        geometry.delays.push_back(velodyneLayout(model).delayInBlock(laser));
    return geometry;
}

ImageGeometry geometryOf(const RotatingScan& scan)
{
    const auto rows = scan.rangeImage.rows();
    if (rows == 1) return lineGeometry(scan);
    if (rows == 16 && scan.lidarModel == "VLP-16")
        return velodyneGeometry(scan, VelodyneModel::VLP16);
    if (rows == 32 && scan.lidarModel == "HDL-32E")
        return velodyneGeometry(scan, VelodyneModel::HDL32E);
    if (rows == 64 && scan.lidarModel == "HDL-64E")
        return velodyneGeometry(scan, VelodyneModel::HDL64E);
    throw std::runtime_error("the elevations of its " + std::to_string(rows) +
                             " rows are not known: sensor '" + scan.lidarModel +
                             "'; VLP-16, HDL-32E, HDL-64E and single rows are");
}

void checkNumbers(const RotatingScan& scan)
{
    const auto& ranges = scan.rangeImage;
    const auto& intensities = scan.intensityImage;
    if (!(scan.rangeResolution > 0.0 && scan.rangeResolution < 1.0))
        throw std::runtime_error("its range resolution is not between 0 and 1 m");
    if (!std::isfinite(scan.startAzimuth + scan.azimuthSpan + scan.sweepDuration) ||
        scan.sweepDuration < 0.0)
        throw std::runtime_error("its azimuths or its duration are no such");
    if (intensities.size() > 0 &&
        (intensities.rows() != ranges.rows() || intensities.cols() != ranges.cols()))
        throw std::runtime_error("its images differ in size");
}
}  // namespace

PointCloud hitsOf(const RotatingScan& scan)
{
    PointCloud cloud;
    if (scan.rangeImage.size() == 0) return cloud;
    checkNumbers(scan);
    const ImageGeometry geometry = geometryOf(scan);
    const bool hasTimes = geometry.period > 0.0;
    const double rate = hasTimes ? geometry.azimuthStep / geometry.period : 0.0;
    for (int column = 0; column < scan.rangeImage.cols(); ++column)
        for (int row = 0; row < scan.rangeImage.rows(); ++row)
        {
            if (scan.rangeImage(row, column) == 0) continue;
            const double range = scan.rangeImage(row, column) * scan.rangeResolution;
            const double elevation = geometry.elevations[static_cast<std::size_t>(row)];
            const double delay = geometry.delays[static_cast<std::size_t>(row)];
            const double azimuth =
                geometry.firstAzimuth + column * geometry.azimuthStep + rate * delay;
            cloud.x.push_back(static_cast<float>(range * std::cos(elevation) * std::cos(azimuth)));
            cloud.y.push_back(static_cast<float>(range * std::cos(elevation) * std::sin(azimuth)));
            cloud.z.push_back(static_cast<float>(range * std::sin(elevation)));
            if (hasTimes)
                cloud.time.push_back(static_cast<float>(column * geometry.period + delay));
            if (scan.intensityImage.size() > 0)
                cloud.intensity.push_back(static_cast<float>(scan.intensityImage(row, column)) /
                                          255.0F);
        }
    return cloud;
}

}  // namespace vdamf
