// SPDX-License-Identifier: BSD-3-Clause
// Velodyne data packets (1206 bytes: 12 blocks of 32 returns): decoded, and encoded for
// simulated sensors. Sources: the HDL-64E S2/S3, HDL-32E and VLP-16 user manuals.
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <string>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
using VelodyneScan = mrpt::obs::CObservationVelodyneScan;

enum class VelodyneModel
{
    VLP16,
    HDL32E,
    HDL64E
};

/// All returns of a scan in the sensor's frame (x forward at azimuth 0, y left, z up), with
/// intensity 0..1 and the firing time of each return relative to the observation's time. MRPT's
/// own conversion loses half of the returns and gives one time a packet. In dual-return packets
/// the second of two equal returns is dropped. The observation's calibration is used where it has
/// one; without it, the nominal elevations. A scan without packets gives its `point_cloud`, with
/// times only if that has them. Throws std::runtime_error on a sensor that it does not know.
PointCloud decodeVelodyne(const VelodyneScan& scan);

/// Seconds from the observation's time to its last firing, without decoding it; 0 where the
/// sensor is unknown or the hits have no times. At most a second.
double durationOf(const VelodyneScan& scan);

/// Elevation of each laser in the order of the packet, rad.
const std::vector<double>& laserElevations(VelodyneModel model);

/// The nominal elevations as a calibration, so that MRPT's own tools can draw the scan.
mrpt::obs::VelodyneCalibration nominalCalibration(VelodyneModel model);

/// The model that recorded the packets. Throws std::runtime_error where there are none, or the
/// sensor is none of those known.
VelodyneModel velodyneModelOf(const VelodyneScan& scan);

/// One firing of all lasers of a sensor.
struct VelodyneFiring
{
    double azimuth = 0.0;          ///< as in the packet: clockwise from forward, rad
    std::vector<float> range;      ///< per laser in packet order, m; 0: no return
    std::vector<float> intensity;  ///< 0..1
};

/// Packs firings, one firing period after another, into an observation (VLP-16: two firings a
/// block; the packets' azimuth is the block's). Each laser fires later than its firing's begin and
/// at a larger azimuth, as decodeVelodyne() has it. Ranges are rounded to 2 mm, intensities to
/// 1/255; ranges beyond 131.07 m count as no return. The last packet is filled up with blocks
/// without returns. `time`: of the first firing, s (UNIX). Used for simulated scans. Throws
/// std::runtime_error where a firing has not as many ranges and intensities as lasers.
VelodyneScan encodeVelodyne(VelodyneModel model, double time,
                            const std::vector<VelodyneFiring>& firings);

}  // namespace vdamf
