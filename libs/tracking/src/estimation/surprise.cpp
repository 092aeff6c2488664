// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/surprise.h"

#include <algorithm>
#include <cmath>

#include "types/cholesky.h"

namespace vdamf
{
Surprise surpriseOf(const PlacedPoint& foretold, const PlacedPoint& measured)
{
    const Innovation innovation = innovationOf(foretold, measured);
    const Cholesky<3> factors(innovation.covariance);
    return {factors.squaredNorm(innovation.value), std::log(factors.determinant())};
}

std::vector<double> likelihoods(const std::vector<Surprise>& foretold, double gate)
{
    double nearest = gate;
    for (std::size_t i = 0; i < foretold.size(); ++i)
        nearest = i == 0 ? foretold[i].nis : std::min(nearest, foretold[i].nis);
    const double weight = std::min(1.0, gate / std::max(1e-9, nearest));
    std::vector<double> logs;
    logs.reserve(foretold.size());
    for (const Surprise& each : foretold)
        logs.push_back(-0.5 * (weight * each.nis + each.logVolume));
    constexpr double kMostEvidence = 6.0;  // log odds, of one measurement
    const double best = *std::max_element(logs.begin(), logs.end());
    for (double& each : logs) each = std::exp(std::max(each - best, -kMostEvidence));
    return logs;
}

}  // namespace vdamf
