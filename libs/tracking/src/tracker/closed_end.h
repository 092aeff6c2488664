// SPDX-License-Identifier: BSD-3-Clause
// What tells a bus from a truck behind: its rear is closed down to its skirt, while below the
// loading floor of a truck there is a bar, and behind that the frame.
#pragma once

#include "tracker/sighting.h"

namespace vdamf
{
/// Whether the end that a sighting shows is as wide and high as a bus's, with hits all along it
/// between the bar and the floor of a truck.
bool isClosedEnd(const Sighting& sighting, const HitsAtOneTime& seen);

}  // namespace vdamf
