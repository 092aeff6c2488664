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

std::array<double, Surprises::kMost> likelihoods(const Surprises& foretold, double gate)
{
    double nearest = gate;
    for (std::size_t i = 0; i < foretold.size; ++i)
        nearest = i == 0 ? foretold.each[i].nis : std::min(nearest, foretold.each[i].nis);
    const double weight = std::min(1.0, gate / std::max(1e-9, nearest));
    std::array<double, Surprises::kMost> logs{};
    for (std::size_t i = 0; i < foretold.size; ++i)
        logs[i] = -0.5 * (weight * foretold.each[i].nis + foretold.each[i].logVolume);
    constexpr double kMostEvidence = 6.0;  // log odds, of one measurement
    const auto end = logs.begin() + static_cast<std::ptrdiff_t>(foretold.size);
    const double best = foretold.size > 0 ? *std::max_element(logs.begin(), end) : 0.0;
    for (auto each = logs.begin(); each != end; ++each)
        *each = std::exp(std::max(*each - best, -kMostEvidence));
    return logs;
}

}  // namespace vdamf
