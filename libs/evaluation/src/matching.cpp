// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/matching.h"

#include <map>

#include "overlaps.h"

namespace vdamf
{
namespace
{
using Overlaps = std::vector<std::vector<double>>;
using Partners = std::map<std::string, std::uint64_t>;  // track by object

/// What a pair is worth: any pair kept outweighs the overlaps of all pairs together.
Overlaps scoresOf(const ScoredFrame& frame, const Overlaps& overlaps, const Partners& before,
                  double minOverlap)
{
    const double keeping = 1.0 + static_cast<double>(frame.truth.size());
    Overlaps scores = overlaps;
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        const auto partner = before.find(frame.truth[i].objectId);
        for (std::size_t j = 0; j < frame.tracks.size(); ++j)
        {
            const bool possible = frame.counts[i] && reaches(overlaps[i][j], minOverlap);
            if (!possible) scores[i][j] = 0.0;
            const bool kept =
                partner != before.end() && partner->second == frame.tracks[j].report.id;
            if (scores[i][j] > 0.0 && kept) scores[i][j] += keeping;
        }
    }
    return scores;
}

bool isOnDontCare(const ScoredFrame& frame, const Overlaps& overlaps, std::size_t track,
                  double minOverlap)
{
    const OrientedBox& box = frame.tracks[track].report.box;
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        if (frame.counts[i]) continue;
        if (isOn(frame.truth[i].box, box, overlaps[i][track], minOverlap)) return true;
    }
    return false;
}

FrameMatches matchFrame(const ScoredFrame& frame, const Partners& before, double minOverlap)
{
    const Overlaps overlaps = overlapsOf(frame);
    const std::vector<int> trackOf = bestAssignment(scoresOf(frame, overlaps, before, minOverlap));
    FrameMatches matches;
    std::vector<bool> taken(frame.tracks.size(), false);
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        if (!frame.counts[i]) continue;
        if (trackOf[i] < 0)
        {
            matches.missed.push_back(i);
            continue;
        }
        const auto track = static_cast<std::size_t>(trackOf[i]);
        taken[track] = true;
        matches.pairs.push_back({i, track, overlaps[i][track]});
    }
    for (std::size_t j = 0; j < frame.tracks.size(); ++j)
    {
        if (taken[j]) continue;
        const bool scored = !isOnDontCare(frame, overlaps, j, minOverlap);
        (scored ? matches.falseAlarms : matches.onDontCare).push_back(j);
    }
    return matches;
}

Partners partnersOf(const ScoredFrame& frame, const FrameMatches& matches)
{
    Partners partners;
    for (const MatchedPair& pair : matches.pairs)
    {
        partners[frame.truth[pair.truth].objectId] = frame.tracks[pair.track].report.id;
    }
    return partners;
}
}  // namespace

std::vector<FrameMatches> matchFrames(const Sequence& sequence, double minOverlap)
{
    std::vector<FrameMatches> result;
    result.reserve(sequence.frames.size());
    Partners before;
    for (const ScoredFrame& frame : sequence.frames)
    {
        result.push_back(matchFrame(frame, before, minOverlap));
        const FrameMatches& now = result.back();
        // As in TrackEval, a frame without anything to pair does not make pairs forgotten.
        const bool nothingToPair =
            now.pairs.empty() && (now.missed.empty() || now.falseAlarms.empty());
        if (!nothingToPair) before = partnersOf(frame, now);
    }
    return result;
}

}  // namespace vdamf
