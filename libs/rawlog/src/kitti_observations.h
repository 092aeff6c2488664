// SPDX-License-Identifier: BSD-3-Clause
// KITTI's samples as MRPT observations.
#pragma once

#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include "vdamf/rawlog/kitti_drive.h"

namespace vdamf
{
mrpt::poses::CPose3D toPose3D(const Eigen::Isometry3d& pose);

mrpt::obs::CObservationRobotPose poseObservation(const Eigen::Isometry3d& vehicleInWorld,
                                                 mrpt::Clock::time_point time);

mrpt::obs::CObservationGPS gpsObservation(const KittiOxts& oxts);

mrpt::obs::CObservationPointCloud scanObservation(const PointCloud& scan,
                                                  const Eigen::Isometry3d& sensorInVehicle,
                                                  mrpt::Clock::time_point time);

}  // namespace vdamf
