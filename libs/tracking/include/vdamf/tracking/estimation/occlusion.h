// SPDX-License-Identifier: BSD-3-Clause
// Hidden is not missing: ends of a target that something nearer hides.
#pragma once

#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/range_profile.h"

namespace vdamf
{
/// Where the ray goes that would see more of a face, past its end, m.
inline constexpr double kPastEnd = 0.6;
/// And where the others go that tell whether it is free beyond, m.
inline constexpr double kFartherPastEnd[] = {kPastEnd, 1.1, 1.6};
/// By how much that ray goes on where nothing is in its way, m.
inline constexpr double kFreeRange = 0.4;

/// Faces of the box that end a row of hits along the face beside them, where the line of sight
/// just past that end is blocked: what it meets may hide the rest of the row, or be the rest of
/// it. A face that is seen itself is never among them. Box and sensor share their frame, m.
FaceSet blockedEnds(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                    const RangeProfile& profile);

/// The same where that line meets the row at such a grazing angle that its hits lie too far apart
/// to tell its end, or may do so, as the heading has an error of `headingSigma` (rad).
FaceSet grazedEnds(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                   double headingSigma = 0.0);

/// Of two faces seen, the one before which, beside their corner, something nearer is in the line of
/// sight: its hits may be the edge of that shadow, across bonnet, windscreen and roof. Nothing
/// where both show through a gap.
FaceSet shadowEdges(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                    const RangeProfile& profile);

/// Where the face beside an end of an axis (0: length, 1: width; low or high) would go on, so many
/// metres past that end. In the frame of the box, m.
Eigen::Vector2d placePastEnd(const OrientedBox& box, const Eigen::Vector2d& sensor, int axis,
                             int end, double metres);

}  // namespace vdamf
