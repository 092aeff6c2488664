// SPDX-License-Identifier: BSD-3-Clause
#include "ins_sensor.h"

#include <mrpt/topography/conversions.h>

#include <cstdio>

namespace vdamf
{
namespace
{
using mrpt::topography::TGeodeticCoords;

std::string text(const char* format, double a, double b, double c)
{
    char buffer[160];
    std::snprintf(buffer, sizeof(buffer), format, a, b, c);
    return buffer;
}

/// East, north, up from the origin, m.
Eigen::Vector3d fromOrigin(const TGeodeticCoords& place, const TGeodeticCoords& origin)
{
    mrpt::math::TPoint3D enu;
    mrpt::topography::geodeticToENU_WGS84(place, enu, origin);
    return {enu.x, enu.y, enu.z};
}
}  // namespace

void InsSensor::insert(const std::string& label, const InsReading& reading)
{
    if (!options_.label.empty() && label != options_.label) return;
    if (label_ && label != *label_) return;
    constexpr double kFarthest = 1e8;  // m, more than twice around the Earth
    if (!reading.valid || reading.sample.position.cwiseAbs().maxCoeff() > kFarthest)
    {
        ++counts_.impossible;
        return;
    }
    const bool better = reading.grade > grade_ && !fixed_;
    if (!label_ || better)
    {
        label_ = label;
        start(reading);
    }
    if (reading.grade != grade_) return;
    take(inWorld(reading));
}

void InsSensor::take(const PoseSample& sample)
{
    constexpr double kClockJump = 1.0;  // s
    const bool late = !samples_.empty() && sample.time < samples_.newestTime();
    if (!samples_.insert(sample))
    {
        ++counts_.duplicates;
        return;
    }
    if (counts_.taken++ > 0 && sample.time < lastTime_ - kClockJump) ++counts_.timeJumps;
    counts_.outOfOrder += late ? 1 : 0;
    lastTime_ = sample.time;
}

InsReport InsSensor::report() const
{
    const InsReport ofSamples = samples_.report();
    InsReport report = counts_;
    report.gaps = ofSamples.gaps;
    report.longestGap = ofSamples.longestGap;
    report.firstGapAt = ofSamples.firstGapAt;
    report.imuLessCourse = ofSamples.imuLessCourse;
    return report;
}

/// The world begins at this reading.
void InsSensor::start(const InsReading& reading)
{
    samples_ = PoseSamples(options_, imu_);
    counts_.taken = 0;
    grade_ = reading.grade;
    geodeticOrigin_ = reading.geodetic;
    origin_.setZero();
    const PoseSample first = inWorld(reading);
    // Without an attitude the way from the antenna to the vehicle is not known yet.
    if (first.attitude) origin_ = first.position;
}

/// Vehicle = sensor's pose (-) sensor's pose on the vehicle.
PoseSample InsSensor::inWorld(const InsReading& reading) const
{
    PoseSample sample = reading.sample;
    if (reading.geodetic && geodeticOrigin_)
    {
        sample.position = fromOrigin(*reading.geodetic, *geodeticOrigin_);
    }
    const Eigen::Vector3d antenna = reading.sensorInVehicle.translation();
    if (!sample.attitude)
    {
        sample.antenna = antenna;
        return sample;
    }
    const Eigen::Quaterniond mounting(reading.sensorInVehicle.linear());
    sample.attitude = *sample.attitude * mounting.conjugate();
    sample.position -= *sample.attitude * antenna + origin_;
    return sample;
}

std::string InsSensor::name() const
{
    if (!label_) return {};
    return nameOf(grade_) + (label_->empty() ? "" : " '" + *label_ + "'");
}

std::string InsSensor::originText() const
{
    if (!label_) return {};
    if (!geodeticOrigin_) return text("%.4f %.4f %.4f m", origin_.x(), origin_.y(), origin_.z());
    const TGeodeticCoords& place = *geodeticOrigin_;
    return text("latitude %.9f deg, longitude %.9f deg, height %.4f m", place.lat.decimal_value,
                place.lon.decimal_value, place.height);
}

}  // namespace vdamf
