// SPDX-License-Identifier: BSD-3-Clause
// Ends of which no hits show the bumper: those on a bonnet or a windscreen lie behind it.
#pragma once

#include "tracker/sighting.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// By which the lowest hits on the end seen lie above where bumpers are, m; 0 where they lie lower,
/// where heights are not known, and of what is as high as a truck, which is upright.
double endAboveBumper(const Sighting& sighting, const HitsAtOneTime& seen);

/// The measurement of a sighting with its end as uncertain as hits so high leave it. Beside a side
/// they may be the edge of what hides the rest, across the roof: then the end is hidden.
Measurement withRecessOfEnd(const Sighting& sighting);

/// A measurement of a target by such a sighting, that points as the target does (alignedWith()).
/// Where its end lies inside of the box foretold, no farther than hits so high may lie behind an
/// end, it tells that it is farther out and not where: it is as much more uncertain as it lies
/// inside.
Measurement withEndAsForetold(const Measurement& measurement, const Sighting& sighting,
                              const VehicleState& foretold);

}  // namespace vdamf
