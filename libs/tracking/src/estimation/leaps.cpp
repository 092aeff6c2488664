// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/leaps.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
// Whether it likely stands, and its speed is known well.
bool isKnownToStand(const MotionHypotheses& h)
{
    constexpr double kLikely = 0.5;      // probability
    constexpr double kSpeedSigma = 0.7;  // m/s
    const VehicleState& drives = h.driving.front();
    const double stands = h.standingProbability;
    const double speed = drives.mean(kSpeed);
    const double variance =
        (1.0 - stands) * (drives.covariance(kSpeed, kSpeed) + stands * speed * speed);
    return stands > kLikely && variance < kSpeedSigma * kSpeedSigma;
}
}  // namespace

bool isSpeedKnown(const MotionHypotheses& h)
{
    constexpr double kStands = 0.7;      // probability
    constexpr double kSpeedSigma = 1.0;  // m/s
    return h.standingProbability > kStands ||
           h.driving.front().covariance(kSpeed, kSpeed) < kSpeedSigma * kSpeedSigma;
}

std::optional<BoxMeasurement> withoutLeap(const MotionHypotheses& h,
                                          const BoxMeasurement& measurement, double nis,
                                          VehicleKalmanFilter& filter)
{
    constexpr double kMostAcceleration = 10.0;  // m/s^2
    constexpr double kAsForetold = 2.0;
    constexpr int kSteps = 8;
    if (nis < kAsForetold || h.sinceMeasured <= 0.0 || !isKnownToStand(h)) return std::nullopt;
    const double mostGain = kMostAcceleration * h.sinceMeasured;
    const VehicleState& driving = h.driving.front();
    const auto gainBy = [&](const BoxMeasurement& m)
    { return std::abs(filter.update(driving, m).mean(kSpeed) - driving.mean(kSpeed)); };
    double gain = gainBy(measurement);
    if (gain <= mostGain) return std::nullopt;
    BoxMeasurement vaguer = measurement;
    for (int step = 0; step < kSteps && gain > mostGain; ++step)
    {
        vaguer.covariance *= std::max(2.0, gain / mostGain);
        gain = gainBy(vaguer);
    }
    return vaguer;
}

}  // namespace vdamf
