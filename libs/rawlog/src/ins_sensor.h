// SPDX-License-Identifier: BSD-3-Clause
// One source of poses: the readings of one sensor, moved to the vehicle and to the world's origin.
#pragma once

#include <mrpt/topography/data_types.h>

#include <memory>
#include <optional>
#include <string>

#include "ins_reading.h"
#include "pose_samples.h"

namespace vdamf
{
/// Follows the sensor it meets first. As long as fix() has not been called, a better grade of
/// reading of the same sensor takes the place of all before.
class InsSensor
{
public:
    /// `imu`: attitudes for readings without one; null: none.
    explicit InsSensor(const InsOptions& options, std::shared_ptr<const ImuAttitudes> imu = nullptr)
        : options_(options), imu_(imu), samples_(options, std::move(imu))
    {
    }

    void insert(const std::string& label, const InsReading& reading);
    void fix() { fixed_ = true; }

    const PoseSamples& samples() const { return samples_; }
    void forgetBefore(double time) { samples_.forgetBefore(time); }
    std::string name() const;
    /// True where its readings are positions alone.
    bool lacksAttitude() const { return label_ && grade_ <= InsReading::Grade::Gga; }
    std::string originText() const;
    InsReport report() const;

private:
    void take(const PoseSample& sample);
    void start(const InsReading& reading);
    PoseSample inWorld(const InsReading& reading) const;

    InsOptions options_;
    std::shared_ptr<const ImuAttitudes> imu_;
    PoseSamples samples_;
    std::optional<std::string> label_;
    InsReading::Grade grade_ = InsReading::Grade::Rmc;
    std::optional<mrpt::topography::TGeodeticCoords> geodeticOrigin_;
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // of the world, in the source's frame, m
    bool fixed_ = false;
    InsReport counts_;  // gaps are among the samples
    double lastTime_ = 0.0;
};

}  // namespace vdamf
