// SPDX-License-Identifier: BSD-3-Clause
// What comes to touch something that stands is another thing: a car that drives past a bush.
#pragma once

#include <vector>

#include "tracker/clutter.h"
#include "tracker/sighting.h"
#include "tracker/track.h"
#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/preprocessing/clustering.h"

namespace vdamf
{
/// The frame with clusters cut that hold something small which stood until now and surely is no
/// vehicle, and others' hits beyond where it was: those become clusters of their own. `targets`: of
/// the tracks, predicted. `clutter`: of these.
SegmentedFrame withNewcomersCutOff(SegmentedFrame frame,
                                   const std::vector<PredictedTarget>& targets,
                                   const std::vector<Track>& tracks, const Clutter& clutter,
                                   const ClusterOptions& options);

}  // namespace vdamf
