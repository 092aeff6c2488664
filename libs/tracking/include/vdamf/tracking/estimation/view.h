// SPDX-License-Identifier: BSD-3-Clause
// From where a target is seen, and how far that is from another view.
#pragma once

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// Where the sensor stands for a target.
struct View
{
    double bearing = 0.0;  ///< of the sensor in the target's frame, from its heading, rad
    double range = 1.0;    ///< from its centre, m
};

/// Box and sensor in one frame, m and rad.
View viewOf(const OrientedBox& box, const Eigen::Vector2d& sensor);

/// How much of a fit's lasting error is another one after a change of view: 0 for the same view, 1
/// for one that shows other parts of the body or shows them with other beams.
double changeOfView(const View& before, const View& after);

}  // namespace vdamf
