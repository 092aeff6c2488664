// SPDX-License-Identifier: BSD-3-Clause
// A look at what is no vehicle and stands: is it where it was? Attention goes to what may be a
// vehicle; walls, poles and hedges are measured now and then and glanced at in between.
#pragma once

#include <cstddef>
#include <vector>

#include "tracker/discriminate.h"
#include "tracker/sighting.h"
#include "tracker/track.h"

namespace vdamf
{
/// Whether the track was likely to stand, its speed is known, and its hits end where they did: else
/// it has to be measured. `mayGrow`: one end along and one across are enough; more of it may show
/// at the other ones, or less.
bool isWhereItWas(const Track& track, const SegmentedFrame& frame,
                  const std::vector<std::size_t>& clusters, bool mayGrow);

/// Whether that is all that has to be known of the track in this frame.
bool isGlanceEnough(const Track& track, const SegmentedFrame& frame,
                    const std::vector<std::size_t>& clusters, const Discriminator& discriminator,
                    const DiscriminatorOptions& options);

/// The track after a frame in which that holds, as large as its hits now are. It stands as likely
/// as before the frame, and no frame tells where more sharply than was foretold.
Track glancedTrack(Track track, const SegmentedFrame& frame,
                   const std::vector<std::size_t>& clusters, const LifecycleOptions& options);

}  // namespace vdamf
