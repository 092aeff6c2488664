// SPDX-License-Identifier: BSD-3-Clause
// Section 3: the signal, hits of one target projected into the horizontal plane.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vdamf
{
/// Gaussian centres m_i of Eq. (2) with weights: hits that share a small cell of the plane are
/// one centre with the weight of all. Structure of arrays; coordinates like those of the clusters:
/// world axes relative to the frame's origin.
struct Hits
{
    std::vector<double> x;       ///< m
    std::vector<double> y;       ///< m
    std::vector<double> weight;  ///< number of hits
    double totalWeight = 0.0;
    /// Of the hits of each centre about it, m^2: by x, by both, by y. Empty: every centre is one
    /// hit.
    std::vector<double> varianceX, covariance, varianceY;
    std::vector<double> height;  ///< of each centre's hits above the ground, mean, m; or empty
    /// Bit k: there are hits from k to k + 1 tenths of a metre above the ground. 0: unknown.
    std::uint64_t heights = 0;
    double time = 0.0;  ///< mean, s after the frame's; 0 where hits have no times

    std::size_t size() const { return x.size(); }

    /// Variance of a centre's hits along a direction of unit length, m^2.
    double varianceAlong(std::size_t i, double dx, double dy) const
    {
        if (varianceX.empty()) return 0.0;
        return dx * dx * varianceX[i] + 2.0 * dx * dy * covariance[i] + dy * dy * varianceY[i];
    }
};

}  // namespace vdamf
