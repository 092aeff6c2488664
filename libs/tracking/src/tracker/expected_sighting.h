// SPDX-License-Identifier: BSD-3-Clause
// The sighting of a track, measured from where it is foretold to be.
#pragma once

#include "tracker/track.h"

namespace vdamf
{
/// Of the hits in some clusters of the frame that it was predicted to.
Sighting expectedSighting(const Track& track, const SegmentedFrame& frame,
                          const std::vector<std::size_t>& clusters, const MeasureOptions& options,
                          const Attention& attention, const MotionOptions& motion);

}  // namespace vdamf
