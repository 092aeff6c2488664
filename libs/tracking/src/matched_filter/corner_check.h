// SPDX-License-Identifier: BSD-3-Clause
// Whether the rows of hits on two faces meet in the corner of both.
#pragma once

#include <optional>

#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// The face that is not one of the vehicle's, of two faces `seen` of a box that lies on them: the
/// hits along the other one go on well beyond it, or end well before it, as they do where a bush or
/// a lone row of hits was taken for a face. Of both the one with fewer hits on it. Nothing where
/// the rows meet, or only one face is seen.
std::optional<Face> misplacedFace(const Hits& hits, const OrientedBox& box, FaceSet seen);

}  // namespace vdamf
