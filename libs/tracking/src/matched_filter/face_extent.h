// SPDX-License-Identifier: BSD-3-Clause
// How far the hits on a seen face reach.
#pragma once

#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// The box with its far ends moved out to where the hits along its seen faces end, its near faces
/// held. Hits thin out along a face that is seen at a grazing angle, and the normalised response
/// then gains by leaving the thin end out; the far end itself is where the row of hits ends. Not
/// in the paper.
OrientedBox reachingOverHits(const Hits& hits, const OrientedBox& box, FaceSet seen,
                             const Eigen::Vector2d& sensor);

}  // namespace vdamf
