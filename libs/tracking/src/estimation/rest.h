// SPDX-License-Identifier: BSD-3-Clause
// Vehicles that stand.
#pragma once

#include "vdamf/tracking/estimation/motion_model.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// In which vehicles that stand may set off, or stop, s.
constexpr double kRestTime = 1.6;

/// The same vehicle at rest, for certain.
VehicleState atRest(const VehicleState& state);

/// What stands `dt` seconds later, still standing.
VehicleState standingLater(const VehicleState& state, double dt, const MotionOptions& options);

/// That it stands in the long run, of what may move like that: what drives on without being seen
/// does not come to stand from one frame to the next.
double restProbability(const VehicleState& moving);

}  // namespace vdamf
