// SPDX-License-Identifier: BSD-3-Clause
// A state some time later, as a model and its linear approximation foretell it.
#pragma once

#include "vdamf/tracking/estimation/motion_model.h"

namespace vdamf
{
inline VehicleState transitioned(const MotionModel& model, const VehicleState& state, double dt)
{
    const StateMatrix f = model.jacobian(state.mean, dt);
    VehicleState next = state;
    next.mean = model.predicted(state.mean, dt);
    next.covariance = f * state.covariance * f.transpose() + model.noise(state.mean, dt);
    return next;
}

}  // namespace vdamf
