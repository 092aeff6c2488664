// SPDX-License-Identifier: BSD-3-Clause
// Sides of vehicles lean inwards: of what stands behind the next one, the windows alone show at the
// far end, and a line through all hits is turned. Those of one height are not.
#pragma once

#include "tracker/sighting.h"

namespace vdamf
{
/// The measurement of a sighting, turned to the direction that rows of hits of one height each on
/// the side seen have in common, or by less: by how much that differs from the direction of all
/// hits together. About the near corner, which stays.
Measurement withTurnOfSideLayers(const Sighting& sighting, const HitsAtOneTime& seen);

}  // namespace vdamf
