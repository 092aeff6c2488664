// SPDX-License-Identifier: BSD-3-Clause
// Where the hits of an object lie at several heights: windscreens and side windows lean inwards,
// walls and hedges do not.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "vdamf/tracking/discrimination/canonical_frame.h"

namespace vdamf
{
/// Mean and scatter of the hits in a band of heights along the side and along the end, m.
struct HeightBand
{
    double x = 0.0;
    double xScatter = 0.0;
    double y = 0.0;
    double yScatter = 0.0;
};

/// Bands of wheels and bumpers, of the windows of cars, and of what only vans and lorries have.
/// Nothing for bands of less than three hits.
using HeightProfile = std::array<std::optional<HeightBand>, 3>;

HeightProfile heightProfileOf(const CanonicalHits& hits);

}  // namespace vdamf
