// SPDX-License-Identifier: BSD-3-Clause
// Several tracks on one object.
#pragma once

#include <vector>

#include "tracker/track.h"

namespace vdamf
{
/// The same tracks; of two on one object the older one stays, unless it was lost from sight for
/// longer, or is clutter and the other one surely a vehicle, and the other one is ended. A new box
/// of a vehicle that was confirmed, where the old one has no hits any more, goes on as that
/// vehicle: it takes its identity, and is confirmed anew (a truck of which more showed than could
/// be its own was another one). `extents`: what each of them covers, m; of what is no vehicle its
/// hits, not the box of the vehicle that it could have been.
std::vector<Track> withDuplicatesEnded(std::vector<Track> tracks, std::vector<OrientedBox> extents);

}  // namespace vdamf
