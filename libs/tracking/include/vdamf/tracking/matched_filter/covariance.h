// SPDX-License-Identifier: BSD-3-Clause
// Section 4.4: covariance of the fit by perturbation of the hits.
#pragma once

#include "vdamf/tracking/matched_filter/filter_shape.h"
#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// Eq. (14) on all five parameters: R = sigma_p^2 H^-1 (sum_i B_i B_i^T) H^-1 with H the Hessian
/// of M and B_i of Eq. (13), for (x, y, heading, length, width) in world axes (m, rad). Against
/// the 3 x 3 form of the paper it does not condition on the size.
///
/// Directions that the hits do not hold (the length of a vehicle seen from behind) have almost no
/// curvature; their curvature counts as at least 1e-4 of the largest, which makes their variance
/// large and finite; a variance of 1 (m^2, rad^2) is added along them, because hits exactly in a
/// row would otherwise tell of certainty.
Matrix5d fitCovariance(const Hits& hits, const FilterShape& shape, const OrientedBox& box,
                       double phi, double hitSigma);

}  // namespace vdamf
