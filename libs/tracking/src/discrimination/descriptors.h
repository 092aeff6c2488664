// SPDX-License-Identifier: BSD-3-Clause
// What of an object's shape does not depend on how densely a sensor scans.
#pragma once

#include <optional>

#include "discrimination/flatness.h"
#include "discrimination/height_profile.h"
#include "discrimination/silhouette.h"
#include "vdamf/tracking/discrimination/canonical_frame.h"

namespace vdamf
{
/// In the canonical frame. "Low" hits are those below the windows: of a vehicle they lie along its
/// faces. Extents are without the 2 % of the hits at either end.
struct Descriptors
{
    double length = 0.0;    ///< extent of the hits along x, m
    double width = 0.0;     ///< extent of the hits along y, m
    double top = 0.0;       ///< above the ground, m
    double bottom = 0.0;    ///< above the ground, m
    double shoulder = 0.0;  ///< height below which 85 % of the hits lie, m
    double middle = 0.0;    ///< median height of the hits, m
    double columns = 0.0;   ///< mean height from the lowest to the highest hit at a place, m
    double outside = 0.0;   ///< share of the hits before the two near faces
    double beyond = 0.0;    ///< share of the hits behind the two far faces
    double match = 0.0;     ///< response of the fit per hit, 1/m
    double density = 0.0;   ///< log2 of the hits per those that a closed surface would have
    double bearing = 0.0;   ///< of the sensor from the end's direction, 0 to pi / 2, rad
    double high = 0.0;      ///< share of the hits above cars
    struct LowHits
    {
        double depth = 0.0;         ///< mean distance to the nearest near face, m
        double near = 0.0;          ///< share within 0.15 m of one
        double straightness = 0.0;  ///< scatter across the faces, m
        double onSide = 0.0;        ///< share that are nearer to the side than to the end
    };
    std::optional<LowHits> low;  ///< nothing where there are too few
    /// Extent along y of the hits below and above the lower edge of the windows, m: roofs are
    /// narrower than what carries them.
    std::optional<double> lowWidth;
    std::optional<double> highWidth;
    Silhouette silhouette;
    Flatness flatness;
    HeightProfile profile;
};

/// Of at least one hit.
Descriptors describe(const CanonicalHits& hits, const ObjectView& view);

}  // namespace vdamf
