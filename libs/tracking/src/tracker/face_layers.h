// SPDX-License-Identifier: BSD-3-Clause
// Hits on a face, in layers of about one height each: what they have in common, wherever each of
// them lies.
//
// Bodies recede with height. Where something hides low hits on one side and high ones on the other,
// a line through all of them is turned; those of one height are not.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/measurement.h"

namespace vdamf
{
/// Of hits about a face.
struct FaceBand
{
    float inFront = 0.0F;   ///< of the face, m
    float behind = 0.0F;    ///< m
    float fromEnds = 0.0F;  ///< of the face, m: round corners; below zero: none
};

/// Sums over hits of the products of (1, m along the face from the box's middle, m behind it).
using LayerSums = Eigen::Matrix3d;

/// Of 0.2 m each; what is higher than 4 m is in the last one.
using Layers = std::array<LayerSums, 20>;

/// The hits about the face of a measured box that lies across `axis` (0: an end, 1: a side), at its
/// end of the sign, in layers of height.
Layers layersOf(const OrientedBox& box, int axis, double sign, const FaceBand& band,
                const Cluster& hits);

/// How much farther behind the face hits are farther along it, m/m.
struct LayerSlope
{
    double within = 0.0;  ///< the layers
    double sigma = 0.0;   ///< of that
    double ofAll = 0.0;   ///< of all hits together
};

/// Nothing where no layer tells.
std::optional<LayerSlope> slopeOf(const Layers& layers);

}  // namespace vdamf
