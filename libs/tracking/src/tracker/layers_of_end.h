// SPDX-License-Identifier: BSD-3-Clause
// Ends of vehicles recede with height: windows behind a bumper, the frame below a truck's box.
// Where something hides low hits on one side and high ones on the other, a line through all of them
// is turned. Those of one height are not.
#pragma once

#include "tracker/sighting.h"

namespace vdamf
{
/// The measurement of a sighting, turned by the difference between what rows of hits of one height
/// each and all hits together tell of the direction of its end: where no side is seen, something
/// hides a part of the end, and the rows tell it better than the measurement. That of a truck,
/// whose end is flat, is turned to where its rows are, if that is less: it may lie along one
/// already.
Measurement withTurnOfLayers(const Sighting& sighting, const HitsAtOneTime& seen);

}  // namespace vdamf
