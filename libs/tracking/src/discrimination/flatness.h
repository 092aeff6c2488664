// SPDX-License-Identifier: BSD-3-Clause
// How flat an object is, and how flat and how upright each of its near faces: walls and the sides
// of vans are flat and upright, those of cars bend and lean inwards, leaves scatter.
#pragma once

#include <optional>

#include "vdamf/tracking/discrimination/canonical_frame.h"

namespace vdamf
{
/// The hits within half a metre of one near face.
struct FaceShape
{
    double share = 0.0;             ///< of all hits
    std::optional<double> scatter;  ///< across their plane, m; nothing of a few hits
    std::optional<double> tilt;     ///< of their plane: 0 upright, 1 level
};

struct Flatness
{
    FaceShape side;
    FaceShape end;
    /// Scatter of all hits along their principal axes, m.
    double least = 0.0;
    double middle = 0.0;
    double greatest = 0.0;
};

/// Of at least one hit.
Flatness flatnessOf(const CanonicalHits& hits);

}  // namespace vdamf
