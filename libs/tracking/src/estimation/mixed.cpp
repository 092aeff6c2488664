// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/mixed.h"

namespace vdamf
{
VehicleState mixed(const VehicleState& one, const VehicleState& other, double p)
{
    StateVector between = other.mean - one.mean;
    between(kHeading) = wrapAngle(between(kHeading));
    VehicleState state = one;
    state.mean = one.mean + p * between;
    state.mean(kHeading) = wrapAngle(state.mean(kHeading));
    state.covariance = (1.0 - p) * one.covariance + p * other.covariance +
                       p * (1.0 - p) * between * between.transpose();
    state.width = (1.0 - p) * one.width + p * other.width;
    state.widthVariance = (1.0 - p) * one.widthVariance + p * other.widthVariance;
    return state;
}

}  // namespace vdamf
