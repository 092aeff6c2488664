// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/attention.h"

#include <cstdint>
#include <limits>

namespace vdamf
{
bool isPassedOver(const Track& track, const Discriminator& discriminator)
{
    constexpr int kYoung = 6;             // sightings
    constexpr double kSurelyNone = 0.01;  // probability
    constexpr std::uint64_t kLookAgain = 4;
    constexpr std::uint64_t kLookAgainIfSure = 8;
    if (track.sightings < kYoung || !discriminator.rulesOut(track)) return false;
    const bool isSure = discriminator.vehicleProbability(track) < kSurelyNone;
    const std::uint64_t turn = static_cast<std::uint64_t>(track.sightings) + 1 + track.id;
    return turn % (isSure ? kLookAgainIfSure : kLookAgain) != 0;
}

SearchEffort effortFor(const Track& track, const Discriminator& discriminator)
{
    constexpr double kVague = 0.3;      // m
    constexpr double kPoorMatch = 0.6;  // of the last one
    if (isPassedOver(track, discriminator)) return {0.0, true};
    const bool isVague = track.positionSigma() >= kVague;
    return {isVague ? std::numeric_limits<double>::infinity() : kPoorMatch * track.lastMatch,
            false};
}

}  // namespace vdamf
