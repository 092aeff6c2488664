// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/hindsight/hindsight.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "hindsight/one_front.h"
#include "hindsight/one_size.h"
#include "hindsight/smoothed.h"

namespace vdamf
{
namespace
{
// What the frames called it, each by its hits. Where the discriminator did not run, nothing.
TrackHistory asVehicleOrNone(TrackHistory history)
{
    double hits = 0.0;
    double probability = 0.0;
    double called = 0.0;
    for (const TrackMoment& moment : history)
    {
        const TrackReport& report = moment.report;
        if (!isPublished(report) || !report.vehicleProbability) continue;
        hits += report.points;
        probability += report.points * *report.vehicleProbability;
        called += isCalledVehicle(report).value_or(false) ? report.points : 0.0;
    }
    if (hits == 0.0) return history;
    for (TrackMoment& moment : history)
    {
        moment.report.vehicleProbability = probability / hits;
        if (moment.report.isVehicle) moment.report.isVehicle = called > 0.5 * hits;
    }
    return history;
}

// It was there when it was first seen.
TrackHistory confirmedFromTheStart(TrackHistory history)
{
    for (TrackMoment& moment : history)
        if (moment.report.status == TrackStatus::Tentative)
            moment.report.status =
                moment.report.points > 0 ? TrackStatus::Confirmed : TrackStatus::Coasting;
    return history;
}

bool wasBelieved(const TrackHistory& history)
{
    constexpr std::ptrdiff_t kEnough = 3;  // measured frames: fewer may err
    const auto isBelieved = [](const TrackMoment& moment)
    { return moment.report.status == TrackStatus::Confirmed && moment.report.points > 0; };
    return std::count_if(history.begin(), history.end(), isBelieved) >= kEnough;
}

TrackHistory inHindsight(TrackHistory history)
{
    if (!wasBelieved(history)) return history;
    history = asVehicleOrNone(std::move(history));
    const bool isVehicle = isCalledVehicle(history.front().report).value_or(true);
    const auto isOfHits = [](const TrackMoment& moment) { return moment.report.isOfHits; };
    // What is ruled out is told as its hits lie in each frame.
    if (!isVehicle && std::any_of(history.begin(), history.end(), isOfHits))
        return confirmedFromTheStart(std::move(history));
    history = withOneFront(std::move(history));
    if (isVehicle) history = withOneSize(std::move(history));
    return confirmedFromTheStart(smoothed(std::move(history)));
}
}  // namespace

std::vector<FrameResult> inHindsight(std::vector<FrameResult> frames)
{
    struct Place
    {
        double time;
        TrackReport* report;  // in the frames
    };
    std::map<std::uint64_t, std::vector<Place>> placesOf;  // of each track
    for (FrameResult& frame : frames)
        for (TrackReport& report : frame.tracks)
            placesOf[report.id].push_back({frame.time, &report});
    for (const auto& [id, places] : placesOf)
    {
        TrackHistory history;
        history.reserve(places.size());
        for (const Place& place : places) history.push_back({place.time, std::move(*place.report)});
        history = inHindsight(std::move(history));
        for (std::size_t k = 0; k < places.size(); ++k)
            *places[k].report = std::move(history[k].report);
    }
    return frames;
}

}  // namespace vdamf
