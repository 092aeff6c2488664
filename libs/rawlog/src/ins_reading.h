// SPDX-License-Identifier: BSD-3-Clause
// What an observation says about the pose of the vehicle.
#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/topography/data_types.h>

#include <optional>
#include <string>

#include "pose_samples.h"

namespace vdamf
{
struct InsReading
{
    /// What a receiver may send at the same time, the best last.
    enum class Grade
    {
        Rmc,       ///< position without height
        Gga,       ///< position
        Inspvas,   ///< position and attitude
        Odometry,  ///< CObservationOdometry
        Movement,  ///< of an action
        RobotPose  ///< CObservationRobotPose
    };

    Grade grade = Grade::RobotPose;
    bool valid = false;  ///< the rest is set, and can be
    /// The position is in the source's own frame, m; zero for GPS.
    PoseSample sample;
    std::optional<mrpt::topography::TGeodeticCoords> geodetic;  ///< of the antenna, GPS only
    /// The sensor's frame in the vehicle's.
    Eigen::Isometry3d sensorInVehicle = Eigen::Isometry3d::Identity();
};

/// Nothing for observations of other classes, and GPS messages without a position.
std::optional<InsReading> insReading(const mrpt::obs::CObservation& observation);

/// "CObservationGPS (INSPVAS)".
std::string nameOf(InsReading::Grade grade);

}  // namespace vdamf
