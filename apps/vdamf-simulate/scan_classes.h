// SPDX-License-Identifier: BSD-3-Clause
// Simulated scans as observations of MRPT, in the class asked for.
#pragma once

#include <mrpt/obs/CObservation.h>

#include "vdamf/simulation/scenario.h"

namespace vdamf
{
/// By the scenario's scan_class:
///  - native: a CObservationVelodyneScan, or of a line scanner a CObservation2DRangeScan;
///  - point_cloud: a CObservationPointCloud in the sensor's frame;
///  - rotating_scan: a CObservationRotatingScan; frozen revolutions have the duration 0.
/// The label is the sensor's.
mrpt::obs::CObservation::Ptr scanObservation(const Scenario& scenario, const SimulatedScan& scan);

}  // namespace vdamf
