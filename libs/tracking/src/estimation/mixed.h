// SPDX-License-Identifier: BSD-3-Clause
// Several Gaussians as one.
#pragma once

#include <array>
#include <cstddef>

#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// Mean and covariance of `one`, or with probability p of `other`; steering as of the first one.
VehicleState mixed(const VehicleState& one, const VehicleState& other, double p);

/// The same mean, and the covariance around it if the probability of `other` is `ofSpread`.
VehicleState mixed(const VehicleState& one, const VehicleState& other, double p, double ofSpread);

/// Mean and covariance of states that are mixed more than once, with other weights each time.
class Mixture
{
public:
    static constexpr std::size_t kStates = 3;
    using Weights = std::array<double, kStates>;

    explicit Mixture(const std::array<VehicleState, kStates>& states);

    /// With weights of any sum; steering as of the state numbered `own`.
    VehicleState of(const Weights& weights, std::size_t own) const;

private:
    const std::array<VehicleState, kStates>& states_;
    // From the mean of the first state on:
    std::array<StateVector, kStates> means_;
    std::array<StateMatrix, kStates> squares_;  // expected
};

}  // namespace vdamf
