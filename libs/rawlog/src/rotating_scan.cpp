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

namespace
{
/// Makes hits of the cells of a range image.
class ImageReader
{
public:
    explicit ImageReader(const RotatingScan& scan)
        : scan_(scan), geometry_(geometryOf(scan)), hasTimes_(geometry_.period > 0.0)
    {
    }

    /// Cells that the image before, if there is one, has with the same range are left out.
    void read(const mrpt::math::CMatrix_u16& ranges, const mrpt::math::CMatrix_u16* before)
    {
        for (int column = 0; column < ranges.cols(); ++column)
            for (int row = 0; row < ranges.rows(); ++row)
            {
                const std::uint16_t range = ranges(row, column);
                if (range == 0 || (before != nullptr && (*before)(row, column) == range)) continue;
                add(row, column, range * scan_.rangeResolution);
            }
    }

    PointCloud cloud() && { return std::move(cloud_); }

private:
    void add(int row, int column, double range)
    {
        const double rate = hasTimes_ ? geometry_.azimuthStep / geometry_.period : 0.0;
        const double elevation = geometry_.elevations[static_cast<std::size_t>(row)];
        const double delay = geometry_.delays[static_cast<std::size_t>(row)];
        const double azimuth =
            geometry_.firstAzimuth + column * geometry_.azimuthStep + rate * delay;
        cloud_.x.push_back(static_cast<float>(range * std::cos(elevation) * std::cos(azimuth)));
        cloud_.y.push_back(static_cast<float>(range * std::cos(elevation) * std::sin(azimuth)));
        cloud_.z.push_back(static_cast<float>(range * std::sin(elevation)));
        if (hasTimes_) cloud_.time.push_back(static_cast<float>(column * geometry_.period + delay));
        if (scan_.intensityImage.size() > 0)
            cloud_.intensity.push_back(static_cast<float>(scan_.intensityImage(row, column)) /
                                       255.0F);
    }

    const RotatingScan& scan_;
    ImageGeometry geometry_;
    bool hasTimes_;
    PointCloud cloud_;
};
}  // namespace

PointCloud hitsOf(const RotatingScan& scan)
{
    if (scan.rangeImage.size() == 0) return {};
    checkNumbers(scan);
    ImageReader reader(scan);
    reader.read(scan.rangeImage, nullptr);
    // Further returns of the same shots.
    for (const auto& [name, ranges] : scan.rangeOtherLayers)
    {
        const bool fits =
            ranges.rows() == scan.rangeImage.rows() && ranges.cols() == scan.rangeImage.cols();
        if (fits) reader.read(ranges, &scan.rangeImage);
    }
    return std::move(reader).cloud();
}

}  // namespace vdamf
