// SPDX-License-Identifier: BSD-3-Clause
// Pose samples sorted by time, and the pose between them.
#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <memory>
#include <optional>
#include <utility>

#include "imu_attitudes.h"
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
    /// `imu`: attitudes for samples without one; null: none.
    PoseSamples(const InsOptions& options, std::shared_ptr<const ImuAttitudes> imu)
        : options_(options), imu_(std::move(imu))
    {
    }

    /// False for a time that is there already.
    bool insert(const PoseSample& sample);
    std::optional<VehiclePose> at(double time) const;
    bool empty() const { return samples_.empty(); }
    /// A sample stands at the time or soon behind it. One with a time far ahead says nothing.
    bool covers(double time) const;
    double newestTime() const { return samples_.back().time; }
    /// Keeps what at() needs from this time on.
    void forgetBefore(double time);
    /// `gaps` and what goes with them, `imuLessCourse`.
    InsReport report() const;

private:
    bool connected(std::size_t i) const;
    std::optional<VehiclePose> interpolated(std::size_t i, double time) const;
    std::optional<VehiclePose> extrapolated(std::size_t from, std::size_t other, double time) const;
    std::optional<Eigen::Quaterniond> attitudeOf(std::size_t i) const;
    std::optional<double> courseOf(std::size_t i) const;
    std::optional<std::size_t> drivenBefore(std::size_t i) const;
    std::optional<std::size_t> drivenAfter(std::size_t i) const;
    std::size_t before(std::size_t i, double reach) const;
    std::size_t after(std::size_t i, double reach) const;
    std::pair<Eigen::Vector3d, Eigen::Vector3d> velocitiesIn(std::size_t i) const;
    VehiclePose poseOf(double time, const Eigen::Vector3d& position,
                       const Eigen::Quaterniond& attitude, std::size_t like) const;

    void compareWithCourse(double course);

    InsOptions options_;
    std::shared_ptr<const ImuAttitudes> imu_;
    std::deque<PoseSample> samples_;
    std::optional<double> lastCourse_;  // of the newest sample that had one, for standstill
    InsReport forgotten_;               // of what is no more among samples_
    Eigen::Vector2d imuLessCourse_ = Eigen::Vector2d::Zero();  // sum of unit vectors
};

}  // namespace vdamf
