// SPDX-License-Identifier: BSD-3-Clause
// Fig. 9: a whole frame from above, vehicles told from clutter.
#pragma once

#include <string>

#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// Hits above the ground, the platform blue, confirmed tracks red where the discriminator calls
/// them vehicles and green else, each with a dashed line to the sensor.
std::string sceneSvg(const LadarFrame& frame, const FrameResult& result);

}  // namespace vdamf
