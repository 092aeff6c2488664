// SPDX-License-Identifier: BSD-3-Clause
// Takes out of a sequence what no metric may see.
#pragma once

#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// Without the objects that do not count and the tracks on them: those that matchFrames() calls
/// onDontCare. The way of KITTI: tracks are matched to what counts first, so that a don't-care
/// object near a car takes no track away from it. HOTA and IDF1 are computed on what is left;
/// CLEAR MOT says the same through FrameMatches.
Sequence withoutDontCare(const Sequence& sequence, double minOverlap);

}  // namespace vdamf
