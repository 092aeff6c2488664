// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
namespace
{
constexpr TrackStatus kAll[] = {TrackStatus::Tentative, TrackStatus::Confirmed,
                                TrackStatus::Coasting, TrackStatus::Ended};
}  // namespace

const char* toString(TrackStatus status)
{
    switch (status)
    {
        case TrackStatus::Tentative:
            return "tentative";
        case TrackStatus::Confirmed:
            return "confirmed";
        case TrackStatus::Coasting:
            return "coasting";
        case TrackStatus::Ended:
            return "ended";
    }
    return "";
}

std::optional<TrackStatus> trackStatusFromString(const std::string& text)
{
    for (const TrackStatus status : kAll)
    {
        if (text == toString(status)) return status;
    }
    return std::nullopt;
}

std::optional<bool> isCalledVehicle(const TrackReport& report)
{
    constexpr double kMoreLikely = 0.5;
    if (report.isVehicle || !report.vehicleProbability) return report.isVehicle;
    return *report.vehicleProbability >= kMoreLikely;
}

}  // namespace vdamf
