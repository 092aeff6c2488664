// SPDX-License-Identifier: BSD-3-Clause
// Two Gaussians as one.
#pragma once

#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// Mean and covariance of `one`, or with probability p of `other`; steering as of the first one.
VehicleState mixed(const VehicleState& one, const VehicleState& other, double p);

}  // namespace vdamf
