// SPDX-License-Identifier: BSD-3-Clause
// One source of poses: the readings of one sensor, moved to the vehicle and to the world's origin.
#pragma once

#include <mrpt/topography/data_types.h>

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
    explicit InsSensor(const InsOptions& options) : options_(options), samples_(options) {}

    void insert(const std::string& label, const InsReading& reading);
    void fix() { fixed_ = true; }

    const PoseSamples& samples() const { return samples_; }
    void forgetBefore(double time) { samples_.forgetBefore(time); }
    std::string name() const;
    std::string originText() const;
    std::size_t taken() const { return taken_; }
    std::size_t dropped() const { return dropped_; }

private:
    void start(const InsReading& reading);
    PoseSample inWorld(const InsReading& reading) const;

    InsOptions options_;
    PoseSamples samples_;
    std::optional<std::string> label_;
    InsReading::Grade grade_ = InsReading::Grade::Rmc;
    std::optional<mrpt::topography::TGeodeticCoords> geodeticOrigin_;
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // of the world, in the source's frame, m
    bool fixed_ = false;
    std::size_t taken_ = 0;
    std::size_t dropped_ = 0;
};

}  // namespace vdamf
