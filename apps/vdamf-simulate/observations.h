// SPDX-License-Identifier: BSD-3-Clause
// Simulated scans and poses as observations of MRPT.
#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include "vdamf/simulation/ins.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
/// A CObservationVelodyneScan, or of a line scanner a CObservation2DRangeScan; the label is the
/// sensor's.
mrpt::obs::CObservation::Ptr scanObservation(const Scenario& scenario, const SimulatedScan& scan);

/// The pose of the platform as the INS has it, label `ins`. Its covariance is that of its errors,
/// and at least that of a good INS (2 cm, 0.1 degrees), because filters divide by it.
mrpt::obs::CObservationRobotPose poseObservation(const Scenario& scenario, const InsSample& sample);

}  // namespace vdamf
