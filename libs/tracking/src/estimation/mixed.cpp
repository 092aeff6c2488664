// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/mixed.h"

namespace vdamf
{
VehicleState mixed(const VehicleState& one, const VehicleState& other, double p)
{
    return mixed(one, other, p, p);
}

VehicleState mixed(const VehicleState& one, const VehicleState& other, double p, double ofSpread)
{
    StateVector between = other.mean - one.mean;
    between(kHeading) = wrapAngle(between(kHeading));
    VehicleState state = one;
    state.mean = one.mean + p * between;
    state.mean(kHeading) = wrapAngle(state.mean(kHeading));
    const double q = ofSpread;
    state.covariance =
        (1.0 - q) * one.covariance + q * other.covariance +
        ((1.0 - q) * p * p + q * (1.0 - p) * (1.0 - p)) * between * between.transpose();
    state.width = (1.0 - p) * one.width + p * other.width;
    state.widthVariance = (1.0 - p) * one.widthVariance + p * other.widthVariance;
    return state;
}

Mixture::Mixture(const std::array<VehicleState, kStates>& states) : states_(states)
{
    for (std::size_t k = 0; k < kStates; ++k)
    {
        means_[k] = states[k].mean - states[0].mean;
        means_[k](kHeading) = wrapAngle(means_[k](kHeading));
        squares_[k] = states[k].covariance + means_[k] * means_[k].transpose();
    }
}

VehicleState Mixture::of(const Weights& weights, std::size_t own) const
{
    const double sum = weights[0] + weights[1] + weights[2];
    VehicleState all;
    all.steering = states_[own].steering;
    StateVector mean = StateVector::Zero();
    for (std::size_t k = 0; k < kStates; ++k)
    {
        const double share = weights[k] / sum;
        mean += share * means_[k];
        all.covariance += share * squares_[k];
        all.width += share * states_[k].width;
        all.widthVariance += share * states_[k].widthVariance;
    }
    all.covariance -= mean * mean.transpose();
    all.mean = states_[0].mean + mean;
    all.mean(kHeading) = wrapAngle(all.mean(kHeading));
    return all;
}

}  // namespace vdamf
