// SPDX-License-Identifier: BSD-3-Clause
// Section 2: LADAR data "transformed into fixed world coordinates" by the INS.
#pragma once

#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
/// A scan in world axes, relative to an origin at the vehicle (whole metres). The hits are taken
/// as seen at the scan's time.
LadarFrame toLadarFrame(const Scan& scan, const VehiclePose& pose);

}  // namespace vdamf
