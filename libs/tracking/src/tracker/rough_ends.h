// SPDX-License-Identifier: BSD-3-Clause
// Vehicles that stand against a hedge: its hits go on where those along a face end.
#pragma once

#include <optional>

#include "tracker/sighting.h"

namespace vdamf
{
/// What is seen of a target but for the hits past an end of one of its faces that lie scattered
/// about that face, not along it; nothing where there are none. The target goes on towards what is
/// left out, as that may hide the rest of it. `sighting`: of all that is `seen`; `leastShare`: of
/// the hits that have to be left, or else they fit a wrong face, and nothing is left out;
/// `mergeCell`: as for projected(), m.
std::optional<HitsAtOneTime> withoutRoughEnd(const Sighting& sighting, const HitsAtOneTime& seen,
                                             double leastShare, double mergeCell, bool planar);

}  // namespace vdamf
