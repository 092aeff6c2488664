// SPDX-License-Identifier: BSD-3-Clause
// From the part of a car that has hits to a box as large as a car, by rules.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// Of the faces that look to the sensor, one that is as wide as cars are (1.2 to 2.5 m) makes the
/// box at least 4.4 m deep behind it, and else one that is as long (3 to 5.8 m) makes it at least
/// 1.85 m: away from the sensor. The default-size corrector of Autoware's shape estimation for
/// cars. Other boxes stay. The heading is along the longer side. One frame for all.
OrientedBox completedToACar(const OrientedBox& box, const Eigen::Vector2d& sensor);

}  // namespace vdamf
