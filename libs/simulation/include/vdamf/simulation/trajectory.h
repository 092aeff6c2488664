// SPDX-License-Identifier: BSD-3-Clause
// Motion in closed form: pose, speed and yaw rate are exact at any time.
#pragma once

#include <memory>
#include <optional>
#include <vector>

namespace vdamf
{
/// A wheeled vehicle in the plane. The reference point is the middle of the rear axle, which
/// moves along the heading (kinematic bicycle without slip).
struct MotionState
{
    double x = 0.0;        ///< rear axle, m
    double y = 0.0;        ///< rear axle, m
    double heading = 0.0;  ///< counter-clockwise from +x, rad, not wrapped
    double speed = 0.0;    ///< along the heading, negative in reverse, m/s
    double yawRate = 0.0;  ///< rad/s
};

/// A stretch of constant acceleration along the heading. The curvature of the path is constant, or
/// changes linearly with time (the steering wheel turns evenly, also at a standstill).
struct MotionSegment
{
    double duration = 0.0;                              ///< s
    double acceleration = 0.0;                          ///< m/s^2
    double curvature = 0.0;                             ///< 1/m, positive to the left; at the begin
    std::optional<double> endCurvature = std::nullopt;  ///< 1/m; nothing: as at the begin
};

/// Where something is at any time.
class Motion
{
public:
    virtual ~Motion() = default;
    virtual MotionState at(double time) const = 0;  ///< scene time, s
};

/// A motion as a value.
class Trajectory
{
public:
    Trajectory() : Trajectory(MotionState{}, {}) {}

    /// Segments one after another from a start at time 0; straight on with the last speed after
    /// the last one, and the first one run backwards before time 0. Without segments: straight
    /// on, or standing where the speed is 0. The start's yaw rate is not used: the curvature of
    /// the segments says it. Positions are exact to 1e-9 m.
    Trajectory(const MotionState& start, const std::vector<MotionSegment>& segments);

    /// Any other motion; not null.
    explicit Trajectory(std::shared_ptr<const Motion> motion) : motion_(std::move(motion)) {}

    MotionState at(double time) const { return motion_->at(time); }

private:
    std::shared_ptr<const Motion> motion_;
};

}  // namespace vdamf
