// SPDX-License-Identifier: BSD-3-Clause
// What a whole run tells of each vehicle, told in all of its frames: for annotation, where nobody
// waits for a frame.
#pragma once

#include <vector>

#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// The frames of a run, in order of time, as far as later frames tell more than those before. A
/// vehicle has one size, the one that was known best; one front; it is a vehicle or none, as most
/// of its hits say; and it was there before it was confirmed. Its motion is smoothed backwards
/// (Rauch, Tung and Striebel 1965), so that the speed that is known later holds before as well.
/// Tracks that were confirmed for less than three frames with hits stay as they are, and the boxes
/// of what is ruled out as a vehicle lie as its hits do. Points, matches, NIS and measured boxes
/// stay those of the frame. Linear in the reports; O(n log n) in the frames of each track.
std::vector<FrameResult> inHindsight(std::vector<FrameResult> frames);

}  // namespace vdamf
