// SPDX-License-Identifier: BSD-3-Clause
// CObservationRotatingScan -> points.
#pragma once

#include <mrpt/obs/CObservationRotatingScan.h>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// The hits of a range image in the sensor's frame, with times where it has a sweep duration.
///
/// The class does not say how high its rows look. That is known of a single row, and of the
/// VLP-16 and HDL-32E, of which CObservationRotatingScan::fromVelodyne() makes images: those turn
/// clockwise, whatever the sign of azimuthSpan, and columnCount is 16 or 32 times too large.
/// Throws std::runtime_error for other sensors.
PointCloud hitsOf(const mrpt::obs::CObservationRotatingScan& scan);

}  // namespace vdamf
