// SPDX-License-Identifier: BSD-3-Clause
// A start for the faces that stands its ground beside bushes and walls.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// A box of the start's size with its near faces along the two lines at right angles that the most
/// hits lie on, whatever lies beside them; of its four headings the nearest to that of the start.
/// The sensor tells which faces are near. Not in the paper.
OrientedBox boxInDensestCorner(const Hits& hits, const OrientedBox& start,
                               const Eigen::Vector2d& sensor);

/// Share of the hits (0..1) on the faces towards the sensor: by exp(-d^2 / (2 scale^2)) with d (m)
/// the distance of a hit to the nearer of them. Those on the roof of a car are on no side.
double shareOnNearFaces(const Hits& hits, const OrientedBox& box, const Eigen::Vector2d& sensor,
                        double scale);

}  // namespace vdamf
