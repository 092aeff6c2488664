// SPDX-License-Identifier: BSD-3-Clause
// How much work a track is worth in a frame: attention goes to what may be a vehicle.
#pragma once

#include "tracker/discriminate.h"
#include "tracker/track.h"

namespace vdamf
{
/// Whether this sighting of what is hardly a vehicle may be passed over. Each fourth is not, nor
/// are the first ones, by which it may have been ruled out by mistake; of what is surely none each
/// eighth is not.
bool isPassedOver(const Track& track, const Discriminator& discriminator);

/// Whether no more than its place is asked for: it is surely no vehicle, and may stand.
bool isPlaceEnough(const Track& track);

/// Where the predicted pose is vague, or explains the hits much worse than before, the search also
/// starts from where the hits are. What is ruled out is followed with less effort: after its first
/// sightings, or at once where its place is enough.
Attention attentionFor(const Track& track, const Discriminator& discriminator);

}  // namespace vdamf
