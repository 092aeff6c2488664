// SPDX-License-Identifier: BSD-3-Clause
// How a state changes as the vehicle turns out longer or wider than was known.
#pragma once

#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// d state / d length (axis 0) or width (1), where the place at `fixed` stays: -1 and 1 at the ends
/// of that axis, 0 in the middle. Centre and axle move; the width is no part of the state's mean.
inline StateVector bySize(const VehicleState& state, int axis, double fixed)
{
    StateVector change = StateVector::Zero();
    change.head<2>() = -0.5 * fixed * rotation(state.mean(kHeading)).col(axis);
    if (axis == 1) return change;
    if (state.steering != Steering::Independent) change(kAxis) = -0.5 * fixed;
    change(kLength) = 1.0;
    return change;
}

}  // namespace vdamf
