// SPDX-License-Identifier: BSD-3-Clause
// Several tracks on one object.
#pragma once

#include <vector>

#include "tracker/track.h"

namespace vdamf
{
/// The same tracks; of two on one object the older one stays, unless it was lost from sight for
/// longer, or is clutter and the other one surely a vehicle, and the other one is ended. `extents`:
/// what each of them covers, m; of what is no vehicle its hits, not the box of the vehicle that it
/// could have been.
std::vector<Track> withDuplicatesEnded(std::vector<Track> tracks,
                                       const std::vector<OrientedBox>& extents);

}  // namespace vdamf
