// SPDX-License-Identifier: BSD-3-Clause
// What of an object's shape the sensor sees at once: its outline and how deep its hits lie there.
#pragma once

#include <optional>

#include "vdamf/tracking/discrimination/canonical_frame.h"

namespace vdamf
{
/// In cells of a quarter of a metre across the line of sight and in height. Nothing where no cells
/// tell it.
struct Silhouette
{
    double breadth = 0.0;   ///< extent across the line of sight, m
    double coverage = 0.0;  ///< share of it with hits: posts in a line are no closed surface
    /// Mean scatter of the depth within a cell, m: leaves scatter, sheet metal does not.
    std::optional<double> thickness;
    std::optional<double> bend;    ///< mean step in depth to the next cell across, m
    std::optional<double> slope;   ///< mean step in depth to the next cell above, m, away positive
    std::optional<double> ragged;  ///< mean bend of the upper outline at a cell, m
};

/// Of at least one hit. `planar`: heights say nothing.
Silhouette silhouetteOf(const CanonicalHits& hits, bool planar);

}  // namespace vdamf
