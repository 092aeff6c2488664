// SPDX-License-Identifier: BSD-3-Clause
// The lasers of the Velodyne sensor that recorded a scan: which model, and where each points.
#pragma once

#include <vector>

#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
/// Corrections of one laser, as in the HDL-64E manual's appendix on calibration.
struct VelodyneLaser
{
    double cosElevation = 1.0;
    double sinElevation = 0.0;
    double rotation = 0.0;          ///< added to no azimuth but taken off it, rad
    double distance = 0.0;          ///< added to the range, m
    double verticalOffset = 0.0;    ///< across the beam, upwards, m
    double horizontalOffset = 0.0;  ///< across the beam, to the left, m
};

/// One for each laser of the model in packet order: from the scan's calibration, else nominal.
/// Throws std::runtime_error where the calibration is that of another sensor.
std::vector<VelodyneLaser> velodyneLasers(const VelodyneScan& scan, VelodyneModel model);

}  // namespace vdamf
