// SPDX-License-Identifier: BSD-3-Clause
// Tracks as the association sees them.
#pragma once

#include <vector>

#include "tracker/discriminate.h"
#include "tracker/track.h"
#include "vdamf/tracking/association/auction.h"

namespace vdamf
{
/// By the tracks, as predicted over so many seconds.
std::vector<PredictedTarget> predictedTargets(const std::vector<Track>& tracks,
                                              const Discriminator& discriminator, double interval,
                                              const LifecycleOptions& options);

}  // namespace vdamf
