// SPDX-License-Identifier: BSD-3-Clause
// The nearest hits above ground around the sensor: what may hide what.
#pragma once

#include "vdamf/tracking/preprocessing/ground.h"
#include "vdamf/tracking/types/range_profile.h"

namespace vdamf
{
/// Profile in sectors of half a degree. Hits lower than 0.6 m hide no vehicle and do not count.
/// Of all heights together, sectors without any that are narrow (0.5 m at the nearer hit beside
/// them, 1 m at the farther one) are as far as the farther one: glass and grazing angles return
/// nothing.
RangeProfile rangeProfile(const LadarFrame& frame, const AboveGround& aboveGround);

}  // namespace vdamf
