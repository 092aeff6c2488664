// SPDX-License-Identifier: BSD-3-Clause
// Motion in closed form: pose, speed and yaw rate are exact at any time.
#pragma once

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

/// A stretch of constant acceleration along the heading and constant curvature of the path.
struct MotionSegment
{
    double duration = 0.0;      ///< s
    double acceleration = 0.0;  ///< m/s^2
    double curvature = 0.0;     ///< 1/m, positive to the left
};

/// Segments one after another from a start at time 0; straight on with the last speed after the
/// last one. Without segments: straight on, or standing where the speed is 0.
class Trajectory
{
public:
    Trajectory() : Trajectory(MotionState{}, {}) {}
    /// The start's yaw rate is not used: the curvature of the segments says it.
    Trajectory(const MotionState& start, const std::vector<MotionSegment>& segments);

    /// State at a time in s; before 0 the first segment is run backwards.
    MotionState at(double time) const;

private:
    struct Piece
    {
        double begin;  ///< s
        MotionState start;
        MotionSegment motion;
    };
    std::vector<Piece> pieces_;
};

}  // namespace vdamf
