// SPDX-License-Identifier: BSD-3-Clause
// CObservation3DRangeScan -> points.
#pragma once

#include <mrpt/obs/CObservation3DRangeScan.h>

#include "vdamf/rawlog/external_files.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// The hits of a range camera (flash LADAR, depth camera) in the sensor's frame, x to where it
/// looks: its points where it has some, else its range image through its camera model. Loads what
/// is in files of their own. Throws where it has neither, or a file is missing.
PointCloud hitsOf(const mrpt::obs::CObservation3DRangeScan& scan, const ExternalFiles& files);

}  // namespace vdamf
