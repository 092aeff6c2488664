// SPDX-License-Identifier: BSD-3-Clause
// The vehicle's way during one scan.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "vdamf/rawlog/ins_trajectory.h"

namespace vdamf
{
/// From vehicle to world axes relative to a frame's origin, m.
struct VehicleInFrame
{
    Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
    Eigen::Vector3f translation = Eigen::Vector3f::Zero();
};

/// The nearest position (m) on a grid of 2^-16 m, 15 micrometres: double precision holds these and
/// their differences exactly, wherever on Earth. So the numbers of a frame are the same bits near
/// the world's origin and far away.
Eigen::Vector3d onGrid(const Eigen::Vector3d& position);

VehicleInFrame vehicleInFrame(const VehiclePose& pose, const Eigen::Vector3d& origin);

/// Poses at steps of time, counted from the scan's time. Between two of the INS trajectory's, 1 ms
/// apart, they lie on the chord: over 1 ms, motion of a vehicle is straight to 10 micrometres.
class ScanPath
{
public:
    /// `pose`: at the scan's time. `times`: of the hits, relative to it, s.
    ScanPath(const std::vector<float>& times, const VehiclePose& pose, const InsTrajectory& ins,
             const Eigen::Vector3d& origin);

    /// Whether a hit's time, relative to the scan's (s), is that of one scan: within a second of
    /// it.
    static bool isPlausible(float time);

    /// The step nearest to a time. Others count as the scan's time.
    static int stepOf(float time);
    const VehicleInFrame& at(int step) const { return steps_[index(step)]; }
    /// Whether the INS gave all poses; else the nearest one on the scan's side stands in.
    bool isComplete() const { return complete_; }

private:
    static constexpr int kStepsPerPose = 10;

    std::size_t index(int step) const { return static_cast<std::size_t>(step - firstStep_); }
    void interpolate(const std::vector<VehicleInFrame>& poses);

    int firstStep_ = 0;
    std::vector<VehicleInFrame> steps_;
    bool complete_ = true;
};

}  // namespace vdamf
