// SPDX-License-Identifier: BSD-3-Clause
// Which end is the front, from the first frame on.
#pragma once

#include "hindsight/track_history.h"

namespace vdamf
{
/// The history without the quarter and half turns that its headings made in no time: length and
/// width lie as most hits had them, and the front is where it was surest.
TrackHistory withOneFront(TrackHistory history);

}  // namespace vdamf
