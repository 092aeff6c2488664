// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/discrimination/classify.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace vdamf
{
double vehicleScore(const DiscriminatorModel& model, const std::vector<float>& features)
{
    assert(features.size() == model.weights.size());
    return std::inner_product(features.begin(), features.end(), model.weights.begin(), model.bias);
}

double hitDecades(std::size_t hits)
{
    return std::log10(std::clamp(static_cast<double>(hits), 5.0, 2000.0) / 50.0);
}

double frameLogOdds(const FrameCalibration& c, double score, std::size_t hits)
{
    const double decades = hitDecades(hits);
    return (c.slope + c.slopePerDecade * decades) * score + c.offset + c.offsetPerDecade * decades;
}

VehicleEvidence withFrame(const VehicleEvidence& evidence, double logOdds,
                          const TrackCalibration& calibration, double prior)
{
    // One frame alone must not decide.
    constexpr double kMost = 6.0;
    const double memory = calibration.memory;
    return {memory * evidence.sum + std::clamp(logOdds - prior, -kMost, kMost),
            memory * evidence.frames + 1.0};
}

double trackLogOdds(const VehicleEvidence& evidence, const TrackCalibration& c)
{
    const double alike = 1.0 + c.correlation * std::max(0.0, evidence.frames - 1.0);
    return std::clamp(c.slope * evidence.sum / alike + c.offset, -c.cap, c.cap);
}

double toProbability(double logOdds)
{
    return 1.0 / (1.0 + std::exp(-logOdds));
}

}  // namespace vdamf
