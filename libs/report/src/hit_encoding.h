// SPDX-License-Identifier: BSD-3-Clause
// The hits of a frame as few bytes for the page.
#pragma once

#include <string>

#include "hit_selection.h"

namespace vdamf
{
/// Whole centimetres, -327.67 to 327.67 m. Little-endian:
///   uint32          number of groups: ground, overhead, structure, then the clusters
///   uint32 x 2      of each group: number of hits, track (0: none)
///   uint8 x 6 n     six planes of one byte a hit: low and high byte of x, of y, of z, each the
///                   difference to the hit before, modulo 2^16
/// Inside of a group hits are in Morton order of x and y, so that differences are small.
std::string encoded(const ShownHits& hits);

}  // namespace vdamf
