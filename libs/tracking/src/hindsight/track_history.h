// SPDX-License-Identifier: BSD-3-Clause
// One track over time.
#pragma once

#include <vector>

#include "vdamf/tracking/types/track.h"

namespace vdamf
{
struct TrackMoment
{
    double time = 0.0;  ///< s (UNIX)
    TrackReport report;
    bool wasAcross = false;  ///< length and width were exchanged
};

/// By rising time.
using TrackHistory = std::vector<TrackMoment>;

}  // namespace vdamf
