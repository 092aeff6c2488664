// SPDX-License-Identifier: BSD-3-Clause
// Published ways from points to a box, to compare with. All return the rectangle around all points
// with the heading along its longer side.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// Points of the plane, one a column; at least one.
using PlanePoints = Eigen::Matrix2Xd;

/// The rectangle around all points at a heading, turned by a quarter where that makes it longer
/// than wide.
OrientedBox boundingBox(const PlanePoints& points, double heading);

/// X. Zhang, W. Xu, C. Dong, J. Dolan: Efficient L-Shape Fitting for Vehicle Detection Using Laser
/// Scanners, IV 2017: search over 0 to 90 degrees in steps of 1 degree. Closeness criterion
/// (Algorithm 3 there; d_0 = 0.01 m).
OrientedBox lShapeByCloseness(const PlanePoints& points);

/// The same with the variance criterion (Algorithm 4 there).
OrientedBox lShapeByVariance(const PlanePoints& points);

/// The rectangle of least area: rotating calipers on the convex hull (G. Toussaint, 1983).
OrientedBox minimumAreaBox(const PlanePoints& points);

/// Heading along the first principal axis.
OrientedBox principalAxisBox(const PlanePoints& points);

}  // namespace vdamf
