// SPDX-License-Identifier: BSD-3-Clause
// Simulated scans as what sensors send.
#pragma once

#include <mrpt/obs/CObservation.h>

#include "vdamf/simulation/scenario.h"

namespace vdamf
{
/// A CObservationVelodyneScan, or of a line scanner a CObservation2DRangeScan. Without label and
/// place on the vehicle.
mrpt::obs::CObservation::Ptr nativeScan(const SimulatedSensor& sensor, const SimulatedScan& scan);

}  // namespace vdamf
