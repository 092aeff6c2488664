// SPDX-License-Identifier: BSD-3-Clause
#include "imu_attitudes.h"

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vdamf
{
namespace
{
using namespace mrpt::obs;

// MRPT copies its flags from the file as they are: in a damaged one they may be no bool at all, and
// its own functions must not look at them.
std::optional<double> valueOf(const CObservationIMU& imu, TIMUDataIndex index)
{
    unsigned char flag = 0;
    std::memcpy(&flag, &imu.dataIsPresent.at(index), sizeof flag);
    if (flag != 1) return std::nullopt;
    return imu.rawMeasurements.at(index);
}

std::optional<Eigen::Quaterniond> attitudeIn(const CObservationIMU& imu)
{
    if (const auto yaw = valueOf(imu, IMU_YAW))
    {
        const double pitch = valueOf(imu, IMU_PITCH).value_or(0.0);
        const double roll = valueOf(imu, IMU_ROLL).value_or(0.0);
        return Eigen::AngleAxisd(*yaw, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
               Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
    }
    const auto x = valueOf(imu, IMU_ORI_QUAT_X);
    const auto y = valueOf(imu, IMU_ORI_QUAT_Y);
    const auto z = valueOf(imu, IMU_ORI_QUAT_Z);
    const auto w = valueOf(imu, IMU_ORI_QUAT_W);
    if (!x || !y || !z || !w) return std::nullopt;
    const Eigen::Quaterniond q(*w, *x, *y, *z);
    constexpr double kTolerance = 0.01;
    if (!(std::abs(q.norm() - 1.0) < kTolerance)) return std::nullopt;
    return q.normalized();
}
}  // namespace

void ImuAttitudes::insert(const CObservationIMU& observation)
{
    const std::string& label = observation.sensorLabel;
    if (!options_.imuLabel.empty() && label != options_.imuLabel) return;
    if (label_ && label != *label_) return;
    const auto inSensor = attitudeIn(observation);
    if (!inSensor || observation.timestamp == INVALID_TIMESTAMP) return;
    const Eigen::Matrix3d mounting = observation.sensorPose.getRotationMatrix().asEigen();
    const Eigen::Quaterniond attitude =
        Eigen::AngleAxisd(options_.imuYawOffset, Eigen::Vector3d::UnitZ()) * *inSensor *
        Eigen::Quaterniond(mounting).conjugate();
    if (!attitude.coeffs().allFinite()) return;
    label_ = label;
    const double time = mrpt::Clock::toDouble(observation.timestamp);
    auto place = readings_.end();
    while (place != readings_.begin() && std::prev(place)->time >= time) --place;
    if (place != readings_.end() && place->time == time) return;
    readings_.insert(place, {time, attitude});
}

std::optional<Eigen::Quaterniond> ImuAttitudes::at(double time) const
{
    const auto after =
        std::lower_bound(readings_.begin(), readings_.end(), time,
                         [](const Reading& reading, double t) { return reading.time < t; });
    const bool hasAfter = after != readings_.end() && after->time - time <= options_.maxGap;
    const bool hasBefore =
        after != readings_.begin() && time - std::prev(after)->time <= options_.maxGap;
    if (hasAfter && hasBefore)
    {
        const Reading& before = *std::prev(after);
        const double share = (time - before.time) / (after->time - before.time);
        return before.attitude.slerp(share, after->attitude);
    }
    if (hasAfter) return after->attitude;
    if (hasBefore) return std::prev(after)->attitude;
    return std::nullopt;
}

void ImuAttitudes::forgetBefore(double time)
{
    while (readings_.size() > 2 && readings_[1].time < time) readings_.pop_front();
}

std::string ImuAttitudes::name() const
{
    return label_ ? "CObservationIMU '" + *label_ + "'" : std::string();
}

}  // namespace vdamf
