// SPDX-License-Identifier: BSD-3-Clause
// What is known of the printed filter's bias, taken off its result.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/matched_filter/filter_parameters.h"
#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// Table 1 answers best with the hits in the middle of its strips, so that its faces lie outside of
/// the vehicle's, the less the more they are seen at a grazing angle. The box with the faces seen
/// moved inwards by the median of that on the simulated cars, vans and trucks of
/// benchmarks/measurement, by face and aspect; its size shrinks by the median excess of that.
OrientedBox withInsets(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                       const InsetParameters& insets = {});

}  // namespace vdamf
