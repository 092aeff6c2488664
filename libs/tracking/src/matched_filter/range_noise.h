// SPDX-License-Identifier: BSD-3-Clause
// The sensor's range noise by the hits themselves.
#pragma once

#include "matched_filter/face_hull.h"

namespace vdamf
{
/// Where nobody tells the noise: it scatters hits alike on both sides of a face, while bodies have
/// theirs inside of it. Of faces with `noise` for a range noise of one metre, standard deviation of
/// the ranges, 0.02 to 0.1 m.
double estimatedRangeNoise(const NearFaces& faces, const LineState& end, const LineState& side);

}  // namespace vdamf
