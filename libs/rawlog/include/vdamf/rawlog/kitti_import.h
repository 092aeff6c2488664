// SPDX-License-Identifier: BSD-3-Clause
// A KITTI raw drive to a rawlog, and its labels to truth.csv.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

#include "vdamf/files/output_file.h"

namespace vdamf
{
struct KittiImport
{
    std::filesystem::path drive;
    std::filesystem::path rawlog;
    std::optional<std::filesystem::path> truth;  ///< labels are read only where it is asked for
    OutputFile::Existing existing = OutputFile::Existing::Refuse;
    int gzLevel = 1;  ///< 0: plain, 1..9
    /// Called after each scan with the scans done and all; false stops the import.
    std::function<bool(std::size_t, std::size_t)> progress;
};

struct KittiImportSummary
{
    std::size_t scans = 0;
    std::size_t missingScans = 0;  ///< left out with their labels: they have no file
    std::size_t poses = 0;
    double seconds = 0.0;  ///< from the first to the last scan
    std::size_t points = 0;
    std::size_t objects = 0;            ///< tracklets
    std::size_t labels = 0;             ///< rows of truth.csv
    std::size_t labelsWithoutPose = 0;  ///< left out: no INS pose at their scan
    bool stopped = false;               ///< by `progress`; nothing was written
};

/// Throws std::runtime_error where an output is an input or both are one file. importKittiDrive()
/// checks it too,
/// before it opens any output.
void checkPaths(const KittiImport& job);

/// Entries by rising time, stamped as in the recording:
///  - CObservationRobotPose `ins`: pose of the vehicle in the world (kittiPoses()), 5 cm, 0.1 deg;
///  - CObservationGPS `gps`: GGA with latitude, longitude, altitude;
///  - CObservationPointCloud `velodyne`: CPointsMapXYZI in the sensor's frame, with sensorPose.
/// Both files appear when all is done, or neither. Throws std::runtime_error that names the file.
KittiImportSummary importKittiDrive(const KittiImport& job);

}  // namespace vdamf
