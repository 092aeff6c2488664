// SPDX-License-Identifier: BSD-3-Clause
// A folder of point clouds to a rawlog.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "vdamf/rawlog/cloud_file.h"
#include "vdamf/rawlog/import_output.h"

namespace vdamf
{
struct CloudImport
{
    std::filesystem::path folder;  ///< its .pcd, .ply and .bin, in the order of their names
    std::filesystem::path poses;   ///< of the vehicle, TUM or KITTI format; empty: none
    std::filesystem::path times;   ///< of the clouds, one a line; empty: see importClouds()
    std::optional<double> rate;    ///< clouds, 1/s, the first one at 0
    PointTime pointTime = PointTime::Auto;
    std::string label = "ladar";
    Eigen::Isometry3d sensorInVehicle = Eigen::Isometry3d::Identity();
    ImportOutput output;
};

struct CloudImportSummary
{
    std::size_t scans = 0;
    std::size_t points = 0;
    std::size_t pointsLeftOut = 0;  ///< as readCloudFile() says
    std::size_t poses = 0;
    double seconds = 0.0;     ///< from the first to the last scan
    std::string times;        ///< where they are from: "times.txt"
    bool pointTimes = false;  ///< the hits have times of their own
    bool stopped = false;     ///< by `progress`; nothing was written
};

/// Throws std::runtime_error where the output is one of the inputs. importClouds() checks it too.
void checkPaths(const CloudImport& job);

/// Entries by rising time:
///  - CObservationRobotPose `ins`: the poses of the file;
///  - of each cloud a CObservationPointCloud (CPointsMapXYZI), or, where the hits have times, a
///    CObservationVelodyneScan that holds points alone: no other class of this MRPT holds them.
/// The clouds' times are from the first of these that there is: the file of times; the rate; poses
/// in TUM format, one for each cloud; the names of the files (seconds, or nano-, micro- or
/// milliseconds since 1970, as their size tells; below 1e8 s with a decimal point alone). Names are
/// sorted by the numbers in them. Throws std::runtime_error that names the file, and the line or
/// byte.
CloudImportSummary importClouds(const CloudImport& job);

}  // namespace vdamf
