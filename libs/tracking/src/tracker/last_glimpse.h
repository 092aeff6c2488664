// SPDX-License-Identifier: BSD-3-Clause
// The last hits on a vehicle that goes out of sight, and on whatever shows of one that is hidden.
#pragma once

#include "tracker/sighting.h"
#include "tracker/track.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// Of what has a known length and goes out of sight the last hits are on any part of it, and where
/// they are expected: they tell that it is there, and not where its faces are. Hits on a corner
/// alone may seem to turn, and a sliver of a rear between two vehicles may be taken for a side.
/// `foretold`: at the time of the hits; `margin`: that hits lie outside of the box, m.
bool isLastGlimpse(const Track& track, const Sighting& sighting, const VehicleState& foretold,
                   double margin);

}  // namespace vdamf
