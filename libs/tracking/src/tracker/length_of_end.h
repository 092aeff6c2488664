// SPDX-License-Identifier: BSD-3-Clause
// How large vehicles are held to be of which not all has been told.
#pragma once

#include "tracker/track.h"

namespace vdamf
{
/// The track no smaller than a vehicle of which that is seen (height: m).
Track grownToAVehicle(Track track, const Measurement& m, double height,
                      const VisibilityOptions& options);

/// The track of what drives out from behind something, after it was seen longer than `foretold`:
/// the next frames will show more of it. With the time of the sighting's hits.
Track goingOnOutOfSight(Track track, const Sighting& sighting, const Measurement& m,
                        const VehicleState& foretold, const VisibilityOptions& options);

/// The track, of which an end alone was ever seen, taken for a longer vehicle as more of that comes
/// into view.
Track withEndFollowed(Track track, const Sighting& sighting, const Measurement& m,
                      const VisibilityOptions& options);

}  // namespace vdamf
