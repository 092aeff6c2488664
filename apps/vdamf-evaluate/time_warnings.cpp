// SPDX-License-Identifier: BSD-3-Clause
#include "time_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "vdamf/evaluation/truth_frames.h"

namespace vdamf
{
namespace
{
/// Frames of one table, by time, and which of them have a counterpart in the other one.
struct Frames
{
    std::vector<double> times;  ///< s
    std::vector<bool> meets;
};

double timeNearest(const std::vector<double>& times, double time)
{
    return times[nearestTime(times, time)];
}

Frames framesBeside(const std::vector<double>& times, const std::vector<double>& others,
                    double tolerance)
{
    Frames frames{times, {}};
    for (const double time : times)
        frames.meets.push_back(std::abs(timeNearest(others, time) - time) <= tolerance);
    return frames;
}

std::vector<double> withoutCounterpart(const Frames& frames)
{
    std::vector<double> times;
    for (std::size_t i = 0; i < frames.times.size(); ++i)
        if (!frames.meets[i]) times.push_back(frames.times[i]);
    return times;
}

/// Of frames that follow each other, s.
double medianPeriod(const std::vector<double>& times)
{
    std::vector<double> periods;
    for (std::size_t i = 1; i < times.size(); ++i) periods.push_back(times[i] - times[i - 1]);
    if (periods.empty()) return 0.0;
    const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
    std::nth_element(periods.begin(), middle, periods.end());
    return *middle;
}

// A truth of every second scan, or of one sensor among several, would else pass for false alarms.
void warnOfFramesWithoutTruth(const Frames& tracks, const TimeSpan& labelled)
{
    std::size_t unknown = 0;
    for (const double time : withoutCounterpart(tracks))
        unknown += time > labelled.first && time < labelled.last ? 1 : 0;
    if (unknown == 0) return;
    std::fprintf(stderr,
                 "vdamf-evaluate: the truth has no row at the time of %zu of the tracks' %zu "
                 "frames; every track in them counts as a false alarm\n",
                 unknown, tracks.times.size());
}

// Tracks of a part of the recording would else pass for a tracker that misses much.
void warnOfTruthOutside(const Frames& truth, const TimeSpan& tracked, const TimeSpan& labelled,
                        const ScoredTables& tables, double tolerance)
{
    const auto isOutside = [&](double time)
    { return time < tracked.first - tolerance || time > tracked.last + tolerance; };
    const auto outside = std::count_if(truth.times.begin(), truth.times.end(), isOutside);
    if (outside == 0) return;
    std::fprintf(stderr,
                 "vdamf-evaluate: %s (%s): %td of its %zu frames are before the first or after the "
                 "last time of %s (%s); their objects count as missed. If these frames were not "
                 "tracked, leave them out with --tracked-span\n",
                 tables.truthName.c_str(), inWords(labelled).c_str(), outside, truth.times.size(),
                 tables.tracksName.c_str(), inWords(tracked).c_str());
}

// A frame without tracks has none near it either; where the nearest one of the tracks belongs to no
// other frame of the truth, one of the clocks is off.
void warnOfShiftedFrames(const Frames& truth, const Frames& tracks, const ScoredTables& tables)
{
    const std::vector<double> alone = withoutCounterpart(tracks);
    if (alone.empty()) return;
    const double near = 0.5 * medianPeriod(truth.times);
    std::size_t beside = 0;
    double farthest = 0.0;
    for (const double time : withoutCounterpart(truth))
    {
        const double distance = std::abs(timeNearest(alone, time) - time);
        if (distance > near) continue;
        ++beside;
        farthest = std::max(farthest, distance);
    }
    if (beside == 0) return;
    std::fprintf(stderr,
                 "vdamf-evaluate: %zu of the %zu frames of %s lie up to %.4f s beside frames of "
                 "%s and have none at their own time; their objects count as missed. Is one of "
                 "the tables shifted against the other?\n",
                 beside, truth.times.size(), tables.truthName.c_str(), farthest,
                 tables.tracksName.c_str());
}
}  // namespace

void warnOfTimes(const ScoredTables& tables, double tolerance)
{
    const std::optional<TimeSpan> labelled = spanOf(tables.truth);
    const std::optional<TimeSpan> tracked = spanOf(tables.tracks);
    if (!labelled || !tracked) return;
    const std::vector<double> truthTimes = frameTimes(tables.truth, tolerance);
    const std::vector<double> trackTimes = frameTimes(tables.tracks, tolerance);
    const Frames truth = framesBeside(truthTimes, trackTimes, tolerance);
    const Frames tracks = framesBeside(trackTimes, truthTimes, tolerance);
    const auto commonFrames = std::count(truth.meets.begin(), truth.meets.end(), true);
    if (commonFrames > 0)  // else there is no scoring
    {
        warnOfFramesWithoutTruth(tracks, *labelled);
        warnOfTruthOutside(truth, *tracked, *labelled, tables, tolerance);
    }
    warnOfShiftedFrames(truth, tracks, tables);
}

}  // namespace vdamf
