// SPDX-License-Identifier: BSD-3-Clause
// Pose samples sorted by time, and the pose between them.
#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <optional>

#include "vdamf/rawlog/ins_trajectory.h"

namespace vdamf
{
/// What one observation says. Without an attitude, `position` is that of the antenna.
struct PoseSample
{
    double time = 0.0;                                   ///< s (UNIX)
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the world, m
    std::optional<Eigen::Quaterniond> attitude;          ///< of the vehicle
    Eigen::Vector3d antenna = Eigen::Vector3d::Zero();   ///< in the vehicle, m
};

class PoseSamples
{
public:
    explicit PoseSamples(const InsOptions& options) : options_(options) {}

    /// False for a time that is there already.
    bool insert(const PoseSample& sample);
    std::optional<VehiclePose> at(double time) const;
    bool empty() const { return samples_.empty(); }
    bool covers(double time) const { return !empty() && samples_.back().time >= time; }
    /// Keeps what at() needs from this time on.
    void forgetBefore(double time);

private:
    bool connected(std::size_t i) const;
    std::optional<VehiclePose> interpolated(std::size_t i, double time) const;
    std::optional<VehiclePose> extrapolated(std::size_t from, std::size_t other, double time) const;
    std::optional<Eigen::Quaterniond> attitudeOf(std::size_t i) const;
    std::optional<double> courseOf(std::size_t i) const;
    std::optional<std::size_t> drivenBefore(std::size_t i) const;
    std::optional<std::size_t> drivenAfter(std::size_t i) const;
    Eigen::Vector3d velocityOf(std::size_t i) const;
    VehiclePose poseOf(double time, const Eigen::Vector3d& position,
                       const Eigen::Quaterniond& attitude, std::size_t like) const;

    InsOptions options_;
    std::deque<PoseSample> samples_;
    std::optional<double> lastCourse_;  // of the newest sample that had one, for standstill
};

}  // namespace vdamf
