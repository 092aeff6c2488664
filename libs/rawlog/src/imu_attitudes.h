// SPDX-License-Identifier: BSD-3-Clause
// What an IMU says about the attitude of the vehicle over time.
#pragma once

#include <mrpt/obs/CObservationIMU.h>

#include <Eigen/Geometry>
#include <deque>
#include <optional>
#include <string>

#include "vdamf/rawlog/ins_trajectory.h"

namespace vdamf
{
/// Follows the first IMU that tells its yaw, or the one with the label asked for.
class ImuAttitudes
{
public:
    explicit ImuAttitudes(const InsOptions& options) : options_(options) {}

    /// Ignores observations without a yaw or a quaternion, or without time, and times that are
    /// there already.
    void insert(const mrpt::obs::CObservationIMU& observation);
    /// Of the vehicle in the world, between two readings, or the nearest one within the longest
    /// gap.
    std::optional<Eigen::Quaterniond> at(double time) const;
    void forgetBefore(double time);
    std::string name() const;  ///< "CObservationIMU 'label'"; empty: none met

private:
    struct Reading
    {
        double time = 0.0;  // s (UNIX)
        Eigen::Quaterniond attitude;
    };

    InsOptions options_;
    std::optional<std::string> label_;
    std::deque<Reading> readings_;  // by time
};

}  // namespace vdamf
