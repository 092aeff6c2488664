// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/dont_care.h"

#include "vdamf/evaluation/matching.h"

namespace vdamf
{
namespace
{
ScoredFrame withoutDontCare(const ScoredFrame& frame, const FrameMatches& matches)
{
    ScoredFrame kept;
    kept.time = frame.time;
    kept.sensor = frame.sensor;
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        if (frame.counts[i]) kept.truth.push_back(frame.truth[i]);
    }
    kept.counts.assign(kept.truth.size(), true);
    std::vector<bool> ignored(frame.tracks.size(), false);
    for (const std::size_t track : matches.onDontCare) ignored[track] = true;
    for (std::size_t j = 0; j < frame.tracks.size(); ++j)
    {
        if (!ignored[j]) kept.tracks.push_back(frame.tracks[j]);
    }
    return kept;
}
}  // namespace

Sequence withoutDontCare(const Sequence& sequence, double minOverlap)
{
    const std::vector<FrameMatches> matches = matchFrames(sequence, minOverlap);
    Sequence kept;
    kept.frames.reserve(sequence.frames.size());
    for (std::size_t i = 0; i < sequence.frames.size(); ++i)
    {
        kept.frames.push_back(withoutDontCare(sequence.frames[i], matches[i]));
    }
    return kept;
}

}  // namespace vdamf
