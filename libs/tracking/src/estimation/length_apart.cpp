// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/length_apart.h"

#include <algorithm>
#include <cmath>

#include "estimation/by_size.h"

namespace vdamf
{
namespace
{
// Whether the place of the end at `at` tells the length.
bool tellsLength(const VehicleState& state, double at)
{
    constexpr double kVague = 0.3;   // m, of the length
    constexpr double kPlaced = 0.5;  // m, of the other end
    if (std::abs(at) < 1.0 || state.covariance(kLength, kLength) < kVague * kVague) return false;
    const int end = at > 0.0 ? 1 : 0;
    return state.faceSigma(0, 1 - end) < std::min(kPlaced, state.faceSigma(0, end));
}
}  // namespace

VehicleState withLengthApart(const VehicleState& state, double at)
{
    const StateVector byLength = bySize(state, 0, tellsLength(state, at) ? -at : at);
    // A P A^T + P_LL b b^T, where b is byLength and A = I - b e_L^T leaves all but the length.
    const StateVector withLength =
        state.covariance.col(kLength) - state.covariance(kLength, kLength) * byLength;
    const StateMatrix less = byLength * withLength.transpose();
    VehicleState next = state;
    next.covariance -= less + less.transpose();
    return next;
}

}  // namespace vdamf
