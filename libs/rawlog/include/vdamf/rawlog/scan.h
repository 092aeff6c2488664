// SPDX-License-Identifier: BSD-3-Clause
// Any scan observation of MRPT as plain points in the vehicle frame.
#pragma once

#include <mrpt/obs/CObservation.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// The hits of one scan in the frame of the vehicle (x forward, y left, z up).
struct Scan
{
    double time = 0.0;  ///< of the observation, s (UNIX)
    std::string sensorLabel;
    Eigen::Vector3d sensorInVehicle = Eigen::Vector3d::Zero();  ///< m
    PointCloud points;  ///< vehicle frame, m; `time` relative to the observation's time
};

/// True where the class is one that scanFrom() reads.
bool isScan(const mrpt::obs::CObservation& observation);

/// The hits of a CObservationPointCloud or CObservationVelodyneScan; nothing for other classes.
/// Drops invalid returns (zero range, NaN); intensities above 1 are taken for 0..255 and scaled.
/// Throws std::runtime_error with the reason where the
/// observation is of a known class but cannot be read (external file missing, null cloud, unknown
/// sensor model).
std::optional<Scan> scanFrom(const mrpt::obs::CObservation& observation);

}  // namespace vdamf
