// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/attention.h"

#include <cstdint>
#include <limits>

namespace vdamf
{
namespace
{
// When little was in view, what is a vehicle may be ruled out by mistake.
bool isYoung(const Track& track)
{
    constexpr int kYoung = 6;  // sightings
    return track.sightings < kYoung;
}
}  // namespace

bool isPassedOver(const Track& track, const Discriminator& discriminator)
{
    constexpr std::uint64_t kLookAgain = 4;
    constexpr std::uint64_t kLookAgainIfSure = 8;
    const bool isSure = isSurelyNone(track);
    if (!discriminator.rulesOut(track) || (isYoung(track) && !isSure)) return false;
    const std::uint64_t turn = static_cast<std::uint64_t>(track.sightings) + 1 + track.id;
    return turn % (isSure ? kLookAgainIfSure : kLookAgain) != 0;
}

bool isPlaceEnough(const Track& track)
{
    return isSurelyNone(track) && !track.moves();
}

Attention attentionFor(const Track& track, const Discriminator& discriminator)
{
    constexpr double kVague = 0.3;      // m
    constexpr double kPoorMatch = 0.6;  // of the last one
    const bool isEnough = isPlaceEnough(track);
    if (discriminator.rulesOut(track) && (isEnough || !isYoung(track)))
        return {{0.0, true}, isEnough};
    const bool isVague = track.positionSigma() >= kVague;
    const double poor =
        isVague ? std::numeric_limits<double>::infinity() : kPoorMatch * track.lastMatch;
    return {{poor, false}, false};
}

}  // namespace vdamf
