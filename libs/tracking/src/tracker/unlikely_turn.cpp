// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/unlikely_turn.h"

#include <cmath>

#include "types/box_changes.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
std::optional<Sighting> turnedToKnownAxes(const Sighting& sighting, const VehicleState& foretold,
                                          double axesProbability)
{
    constexpr double kSure = 0.98;    // probability
    constexpr double kTurning = 0.2;  // rad
    constexpr double kAcross = 1.0;   // rad
    const bool isKnown =
        axesProbability > kSure && foretold.covariance(kHeading, kHeading) < kTurning * kTurning;
    if (!isKnown) return std::nullopt;
    const double turned = wrapAngle(sighting.measurement.box.heading - foretold.mean(kHeading));
    const bool isAcross = std::abs(std::remainder(turned, kPi)) > kAcross;
    if (!isAcross) return std::nullopt;
    // The quarter turn that brings it closest to the heading foretold.
    return turnedBy(sighting, turned > 0.0 ? 3 : 1);
}

Measurement withUnlikelyTurn(const Measurement& measurement, const VehicleState& foretold,
                             const Eigen::Vector2d& hits)
{
    constexpr double kSigmas = 3.0;
    if (measurement.facesSeen.seesSide()) return measurement;
    const double turned = wrapAngle(measurement.box.heading - foretold.mean(kHeading));
    const double lacking = turned * turned / (kSigmas * kSigmas) - measurement.covariance(2, 2) -
                           foretold.covariance(kHeading, kHeading);
    if (lacking <= 0.0) return measurement;
    const Vector5d turn = byTurn(measurement.box.centre() - hits);
    Measurement m = measurement;
    m.covariance += lacking * turn * turn.transpose();
    return m;
}

Measurement turnedBack(const Measurement& measurement, const VehicleState& standing,
                       const Eigen::Vector2d& hits)
{
    constexpr double kFar = 0.1;            // rad
    constexpr double kAcross = 0.25 * kPi;  // rad: length and width may be exchanged
    constexpr double kSure = 0.04;          // rad
    constexpr double kVaguer = 3.0;         // times what is known
    const double turned = wrapAngle(standing.mean(kHeading) - measurement.box.heading);
    const double variance = measurement.covariance(2, 2);
    const double known = standing.covariance(kHeading, kHeading);
    const bool isVague = known < kSure * kSure && variance > kVaguer * kVaguer * known;
    if (std::abs(turned) < kFar || std::abs(turned) > kAcross || !isVague) return measurement;
    const double back = variance / (variance + known) * turned;
    Measurement m = measurement;
    m.box = turnedAbout(hits, back, m.box);
    return m;
}

}  // namespace vdamf
