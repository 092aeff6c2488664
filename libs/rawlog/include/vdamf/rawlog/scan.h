// SPDX-License-Identifier: BSD-3-Clause
// Any scan observation of MRPT as plain points in the vehicle frame.
#pragma once

#include <mrpt/obs/CObservation.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "vdamf/rawlog/external_files.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// The hits of one scan in the frame of the vehicle (x forward, y left, z up).
struct Scan
{
    double time = 0.0;  ///< of the observation, s (UNIX)
    std::string sensorLabel;
    Eigen::Vector3d sensorInVehicle = Eigen::Vector3d::Zero();  ///< m
    PointCloud points;    ///< vehicle frame, m; `time` relative to the observation's time
    bool planar = false;  ///< of a line scanner that is level on the vehicle (within 2 degrees)
};

/// True where the class is one that scanFrom() reads.
bool isScan(const mrpt::obs::CObservation& observation);

/// True for scans of one line: CObservation2DRangeScan, CObservationRotatingScan of one row.
bool isLineScan(const mrpt::obs::CObservation& observation);

/// True for scans that show less than those of a 3D LADAR and are left out beside them: of line
/// scanners and range cameras.
bool isMinorScan(const mrpt::obs::CObservation& observation);

/// Seconds from the observation's time to its last hit, without reading its points; 0 where its
/// hits have no times. At most a second.
double durationOf(const mrpt::obs::CObservation& observation);

/// The hits of one of these, nothing for other classes:
///  - CObservationPointCloud, with the times of the hits where its map is a CPointsMapXYZIRT;
///  - CObservationVelodyneScan, with the time of each hit;
///  - CObservationRotatingScan of a VLP-16, an HDL-32E, an HDL-64E or of one row, with the time of
///  each hit;
///  - CObservation3DRangeScan: its points, else its range image through its camera model;
///  - CObservation2DRangeScan: rays that are valid and shorter than its maximum range.
/// Drops invalid returns (zero range, NaN); intensities above 1 are taken for 0..255 and scaled.
/// Throws std::runtime_error with the reason where the observation is of a known class but cannot
/// be read (external file missing, null cloud, unknown sensor model).
/// `files`: where to look for external ones.
std::optional<Scan> scanFrom(const mrpt::obs::CObservation& observation,
                             const ExternalFiles& files = {});

}  // namespace vdamf
