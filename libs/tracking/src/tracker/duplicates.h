// SPDX-License-Identifier: BSD-3-Clause
// Two tracks on one object.
#pragma once

#include <vector>

#include "tracker/track.h"

namespace vdamf
{
/// Tracks by rising identity, those that end marked so. Of two on one object, one's centre well
/// inside the other's box, that with the more recent sighting stays, the older one of equals. A
/// confirmed track that is missed while a new one stands in its place (a truck whose pieces come as
/// one cluster all at once; what comes out from behind something nearer as an edge that the
/// prediction does not explain) waits for that one to be confirmed. Where the two then move alike
/// it is the same object: it goes on with the older identity.
std::vector<Track> withoutDuplicates(std::vector<Track> tracks);

}  // namespace vdamf
