// SPDX-License-Identifier: BSD-3-Clause
// What the place of a point on a vehicle may tell of its length.
#pragma once

#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// The state with its length known apart from its motion: told from a point of the box at `at`
/// along it (as in BoxMeasurement::fixedPoint), what else is known holds whatever the length is.
/// Where a vehicle's heading jitters and its rear does not, motion seems to tell of a long way
/// between the two; that is not believed. Where little is known of the length, but where the other
/// end is, all else is told from that one, and the place of the end at `at` tells the length.
VehicleState withLengthApart(const VehicleState& state, double at);

}  // namespace vdamf
