// SPDX-License-Identifier: BSD-3-Clause
// A network capture of Velodyne sensors to a rawlog.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/rawlog/import_output.h"
#include "vdamf/rawlog/velodyne_capture.h"
#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
struct VelodyneImport
{
    std::filesystem::path capture;
    std::optional<VelodyneModel> model;  ///< nothing: as the packets say
    std::filesystem::path calibration;   ///< XML of the maker; empty: nominal
    std::filesystem::path poses;         ///< of the vehicle, TUM format; empty: none
    Eigen::Isometry3d sensorInVehicle = Eigen::Isometry3d::Identity();
    double cutAzimuth = 180.0;  ///< where sweeps begin, clockwise from forward, deg
    ImportOutput output;
};

struct VelodyneImportSummary
{
    CaptureSummary capture;
    std::size_t scans = 0;
    std::size_t points = 0;
    std::size_t gps = 0;    ///< sentences with a position
    std::size_t poses = 0;  ///< of the file
    std::size_t clockRestarts = 0;
    double seconds = 0.0;              ///< from the first to the last scan
    std::vector<std::string> sensors;  ///< "velodyne: VLP-16 at 192.168.1.201"
    bool stopped = false;              ///< by `progress`; nothing was written
};

/// Throws std::runtime_error where the output is one of the inputs. importVelodyne() checks it too.
void checkPaths(const VelodyneImport& job);

/// Entries by rising time:
///  - CObservationVelodyneScan `velodyne` (of further sensors `velodyne_2`, ...): the packets of a
///    revolution as they were sent, and the calibration. Its time is that of the first packet by
///    the sensor's clock, which is put beside the capture's once, at the first packet;
///  - CObservationGPS `gps`: RMC or GGA of position packets, one for each new sentence, on the same
///    clock;
///  - CObservationRobotPose `ins`: the poses of the file.
/// A capture that is cut short gives what it holds (summary.capture.problem). Throws
/// std::runtime_error that names the file; also where it holds no data packets, or a sensor that is
/// not known, and for an HDL-64E without a calibration, which each of them has of its own.
VelodyneImportSummary importVelodyne(const VelodyneImport& job);

/// "VLP-16".
std::string nameOf(VelodyneModel model);

}  // namespace vdamf
