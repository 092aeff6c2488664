// SPDX-License-Identifier: BSD-3-Clause
// The end of a vehicle that is nearer to the sensor, beside a side that is seen: nothing of the
// side lies before it.
#pragma once

#include "tracker/sighting.h"

namespace vdamf
{
/// The measurement of a sighting with the near end no farther away than the row of hits on the side
/// begins: where a ring sweeps up a windscreen and another one along the side, the windscreen is
/// not the front. Such an end is told by the row.
Measurement withNearEndOfRow(const Sighting& sighting);

}  // namespace vdamf
