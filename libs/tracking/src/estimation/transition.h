// SPDX-License-Identifier: BSD-3-Clause
// A state some time later, as a model and its linear approximation foretell it.
#pragma once

#include "vdamf/tracking/estimation/motion_model.h"

namespace vdamf
{
/// A F^T. A Jacobian is the identity but for a few entries: the sum over those alone takes a third
/// of the time.
inline StateMatrix timesTransposed(const StateMatrix& a, const StateMatrix& f)
{
    StateMatrix product = a;
    for (Eigen::Index to = 0; to < f.rows(); ++to)
        for (Eigen::Index from = 0; from < f.cols(); ++from)
        {
            const double share = f(to, from) - (to == from ? 1.0 : 0.0);
            if (share != 0.0) product.col(to) += share * a.col(from);
        }
    return product;
}

/// F P F^T of a symmetric P.
inline StateMatrix carried(const StateMatrix& p, const StateMatrix& f)
{
    return timesTransposed(timesTransposed(p, f).transpose(), f);
}

inline VehicleState transitioned(const MotionModel& model, const VehicleState& state, double dt)
{
    const StateMatrix f = model.jacobian(state.mean, dt);
    VehicleState next = state;
    next.mean = model.predicted(state.mean, dt);
    next.covariance = carried(state.covariance, f) + model.noise(state.mean, dt);
    return next;
}

}  // namespace vdamf
