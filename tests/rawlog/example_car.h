// SPDX-License-Identifier: BSD-3-Clause
// A car on a circle, as an INS sees it.
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>
#include <string>

#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf::test
{
inline constexpr double kStart = 1.5e9;
inline constexpr double kSpeed = 14.0;   // m/s
inline constexpr double kRadius = 40.0;  // m

/// A car on a circle to the left, heading through +-pi. It begins at (kRadius, 0), heading north.
struct Car
{
    static double turned(double t) { return kSpeed / kRadius * t; }
    static Eigen::Vector3d position(double t)
    {
        return {kRadius * std::cos(turned(t)), kRadius * std::sin(turned(t)), 0.1 * t};
    }
    static double heading(double t) { return wrapAngle(turned(t) + kPi / 2.0); }
    /// From where the trajectory has its origin.
    static Eigen::Vector3d fromStart(double t) { return position(t) - position(0.0); }
};

inline mrpt::obs::CObservationRobotPose robotPose(double t, const std::string& label = "ins")
{
    mrpt::obs::CObservationRobotPose observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + t);
    observation.sensorLabel = label;
    const Eigen::Vector3d p = Car::position(t);
    observation.pose.mean = mrpt::poses::CPose3D(p.x(), p.y(), p.z(), Car::heading(t), 0.02, -0.01);
    return observation;
}

inline double headingOf(const VehiclePose& pose)
{
    const Eigen::Vector3d forward = pose.attitude * Eigen::Vector3d::UnitX();
    return std::atan2(forward.y(), forward.x());
}

inline double headingError(const VehiclePose& pose, double t)
{
    return std::abs(wrapAngle(headingOf(pose) - Car::heading(t)));
}

inline InsOptions insFrom(InsSource source)
{
    InsOptions options;
    options.source = source;
    return options;
}

}  // namespace vdamf::test
