// SPDX-License-Identifier: BSD-3-Clause
// A drive of the KITTI raw data set as it lies on the disk (Geiger et al., IJRR 2013).
#pragma once

#include <mrpt/core/Clock.h>

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// One sample of the INS (OXTS RT3003), a file of oxts/data.
struct KittiOxts
{
    mrpt::Clock::time_point time;
    double latitude = 0.0;   ///< deg
    double longitude = 0.0;  ///< deg
    double altitude = 0.0;   ///< m
    double roll = 0.0;       ///< rad, 0 level
    double pitch = 0.0;      ///< rad, positive: front down
    double yaw = 0.0;        ///< rad, 0 east, counter-clockwise
    int satellites = 0;
};

/// A scan or sample in a file of its own.
struct KittiFile
{
    std::filesystem::path path;
    mrpt::Clock::time_point time;
    bool isThere = true;
};

/// A synchronised drive without its points and labels. The vehicle frame is that of the INS: x
/// forward, y left, z up.
struct KittiDrive
{
    std::filesystem::path folder;
    std::vector<KittiOxts> oxts;   ///< by rising time
    std::vector<KittiFile> scans;  ///< by rising time; a few may be missing
    Eigen::Isometry3d velodyneInVehicle = Eigen::Isometry3d::Identity();
};

/// Reads `folder` (named like 2011_09_26_drive_0001_sync). Calibration is looked for beside and
/// in it. Throws std::runtime_error that names the file, and the line, for a missing file (up to a
/// tenth of the scans may be missing, as of drive 0009 of 2011_09_26), a bad number, and for
/// numbers of scans, samples and time stamps that do not agree.
KittiDrive readKittiDrive(const std::filesystem::path& folder);

/// The points of one scan in the velodyne's frame, with intensity as in the file. Throws
/// std::runtime_error that names it: missing, empty, cut short, or with a coordinate that is not
/// finite.
PointCloud readKittiScan(const std::filesystem::path& path);

/// Lines like `2011-09-26 13:02:25.963999987`; the clock they show is taken as UTC. Rounded to
/// the 100 ns ticks of MRPT's clock. Throws std::runtime_error that names file and line.
std::vector<mrpt::Clock::time_point> readKittiTimestamps(const std::filesystem::path& path);

/// Poses of the vehicle in the world (x east, y north, z up, origin at the first sample): the
/// Mercator projection of the data set's development kit, with the scale of the first latitude.
std::vector<Eigen::Isometry3d> kittiPoses(const std::vector<KittiOxts>& oxts);

}  // namespace vdamf
