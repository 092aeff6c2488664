// SPDX-License-Identifier: BSD-3-Clause
#include "frame_rows.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "vdamf/evaluation/truth_frames.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
using Frames = std::vector<FrameRows>;

std::vector<double> timesOf(const std::vector<TruthRow>& truth, const std::vector<TrackRow>& tracks,
                            double tolerance)
{
    std::vector<double> all;
    all.reserve(truth.size() + tracks.size());
    for (const TruthRow& row : truth) all.push_back(row.time);
    for (const TrackRow& row : tracks) all.push_back(row.time);
    return frameTimes(std::move(all), tolerance);
}

/// The last frame that begins at this time or before.
FrameRows& frameAt(Frames& frames, double time)
{
    const auto isAfter = [](double t, const FrameRows& frame) { return t < frame.time; };
    return *(std::upper_bound(frames.begin(), frames.end(), time, isAfter) - 1);
}

[[noreturn]] void failTwice(const std::string& what, double time)
{
    throw std::runtime_error(what + " stands twice in the frame at " + toFixedText(time, 6) +
                             " s; keep one of the rows");
}

/// By identity, each of them once.
void sortRows(FrameRows& frame)
{
    const auto truthBefore = [](const TruthRow& a, const TruthRow& b)
    { return a.objectId < b.objectId; };
    const auto sameObject = [](const TruthRow& a, const TruthRow& b)
    { return a.objectId == b.objectId; };
    const auto trackBefore = [](const TrackRow& a, const TrackRow& b)
    { return a.report.id < b.report.id; };
    const auto sameTrack = [](const TrackRow& a, const TrackRow& b)
    { return a.report.id == b.report.id; };
    std::sort(frame.truth.begin(), frame.truth.end(), truthBefore);
    std::sort(frame.tracks.begin(), frame.tracks.end(), trackBefore);
    const auto object = std::adjacent_find(frame.truth.begin(), frame.truth.end(), sameObject);
    if (object != frame.truth.end()) failTwice("object '" + object->objectId + "'", frame.time);
    const auto track = std::adjacent_find(frame.tracks.begin(), frame.tracks.end(), sameTrack);
    if (track == frame.tracks.end()) return;
    failTwice("track " + std::to_string(track->report.id), frame.time);
}

std::optional<PlanePose> poseIn(const FrameRows& frame)
{
    for (const TruthRow& row : frame.truth)
    {
        if (row.sensor) return row.sensor;
    }
    return std::nullopt;
}

PlanePose poseBetween(const FrameRows& before, const FrameRows& after, double time)
{
    const PlanePose& a = *before.sensor;
    const PlanePose& b = *after.sensor;
    const double part = (time - before.time) / (after.time - before.time);
    return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
            wrapAngle(a.heading + part * wrapAngle(b.heading - a.heading))};
}

void placeSensor(Frames& frames)
{
    for (FrameRows& frame : frames) frame.sensor = poseIn(frame);
    const auto hasPose = [](const FrameRows& frame) { return frame.sensor.has_value(); };
    auto before = std::find_if(frames.begin(), frames.end(), hasPose);
    while (before != frames.end())
    {
        const auto after = std::find_if(before + 1, frames.end(), hasPose);
        if (after == frames.end()) return;
        for (auto frame = before + 1; frame != after; ++frame)
        {
            frame->sensor = poseBetween(*before, *after, frame->time);
        }
        before = after;
    }
}

void checkCommonTime(const Frames& frames, const std::vector<TruthRow>& truth,
                     const std::vector<TrackRow>& tracks)
{
    const auto isCommon = [](const FrameRows& frame)
    { return !frame.truth.empty() && !frame.tracks.empty(); };
    if (tracks.empty() || std::any_of(frames.begin(), frames.end(), isCommon)) return;
    failNothingCommon(*spanOf(truth), *spanOf(tracks));
}

void keepLabelledSpan(Frames& frames)
{
    const auto hasTruth = [](const FrameRows& frame) { return !frame.truth.empty(); };
    frames.erase(std::find_if(frames.rbegin(), frames.rend(), hasTruth).base(), frames.end());
    frames.erase(frames.begin(), std::find_if(frames.begin(), frames.end(), hasTruth));
}
}  // namespace

std::vector<FrameRows> framesOf(const std::vector<TruthRow>& truth,
                                const std::vector<TrackRow>& tracks, double tolerance)
{
    if (truth.empty())
    {
        throw std::runtime_error("the truth has no rows: there is nothing to score tracks against");
    }
    Frames frames;
    for (const double time : timesOf(truth, tracks, tolerance)) frames.emplace_back().time = time;
    for (const TruthRow& row : truth) frameAt(frames, row.time).truth.push_back(row);
    for (const TrackRow& row : tracks) frameAt(frames, row.time).tracks.push_back(row);
    for (FrameRows& frame : frames) sortRows(frame);
    checkCommonTime(frames, truth, tracks);
    keepLabelledSpan(frames);
    placeSensor(frames);
    return frames;
}

}  // namespace vdamf
