// SPDX-License-Identifier: BSD-3-Clause
// How long and wide a vehicle is, from the first frame on.
#pragma once

#include "hindsight/track_history.h"

namespace vdamf
{
/// The history with the length and the width that were known best, each the last of those almost as
/// sure as the surest. What was measured of the box stays where it is.
TrackHistory withOneSize(TrackHistory history);

}  // namespace vdamf
