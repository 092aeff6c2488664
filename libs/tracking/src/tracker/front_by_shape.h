// SPDX-License-Identifier: BSD-3-Clause
// Which end of a car or van is its front, by its shape: a windscreen stands behind a bonnet, while
// the windows at the rear stand over the bumper, or behind a shorter boot.
#pragma once

#include "tracker/sighting.h"

namespace vdamf
{
/// Log odds that the front lies where the heading of the measurement points rather than behind, by
/// how far behind the ends the hits at the height of windows begin; 0 where that tells nothing.
double frontByShape(const Sighting& sighting, const HitsAtOneTime& seen);

}  // namespace vdamf
