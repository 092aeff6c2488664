// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/discrimination/classify.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
double vehicleScore(const DiscriminatorModel& model, const std::vector<float>& features)
{
    assert(features.size() == model.weights.size());
    double score = 0.0;
    inWideLanes([
        weights = model.weights.data(), values = features.data(), size = features.size(), result = &
        score
    ]() __attribute__((always_inline)) {
        Doubles sum{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles weight;
            HalfOfFloats value;
            load(weight, weights + first, count);
            load(value, values + first, count);
            sum += weight * __builtin_convertvector(value, Doubles);
        };
        inGroupsOf<kLanes<Doubles>>(size, add);
        *result = sumOf(sum);
    });
    return model.bias + score;
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
