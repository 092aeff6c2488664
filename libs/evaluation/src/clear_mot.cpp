// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/clear_mot.h"

#include <cassert>
#include <map>
#include <optional>

#include "share.h"

namespace vdamf
{
namespace
{
/// One object over the frames in which it counts.
struct History
{
    std::size_t frames = 0;
    std::size_t found = 0;
    std::size_t switches = 0;
    std::size_t fragmentations = 0;
    std::optional<std::uint64_t> lastTrack;
    bool isFound = false;  // in the last of its frames

    void addFound(std::uint64_t track)
    {
        if (lastTrack && *lastTrack != track) ++switches;
        if (lastTrack && !isFound) ++fragmentations;
        ++frames;
        ++found;
        lastTrack = track;
        isFound = true;
    }
    void addMissed()
    {
        ++frames;
        isFound = false;
    }
};

using Histories = std::map<std::string, History>;

Histories historiesOf(const Sequence& sequence, const std::vector<FrameMatches>& matches)
{
    Histories histories;
    for (std::size_t f = 0; f < matches.size(); ++f)
    {
        const ScoredFrame& frame = sequence.frames[f];
        for (const MatchedPair& pair : matches[f].pairs)
        {
            History& history = histories[frame.truth[pair.truth].objectId];
            history.addFound(frame.tracks[pair.track].report.id);
        }
        for (const std::size_t i : matches[f].missed)
        {
            histories[frame.truth[i].objectId].addMissed();
        }
    }
    return histories;
}

/// What the histories of the objects say.
ClearMot countsOf(const Histories& histories)
{
    ClearMot result;
    result.objects = histories.size();
    for (const auto& [id, history] : histories)
    {
        result.truePositives += history.found;
        result.falseNegatives += history.frames - history.found;
        result.identitySwitches += history.switches;
        result.fragmentations += history.fragmentations;
        // In whole numbers: 4 of 5 frames are not more than 80 %.
        const bool mostlyTracked = 5 * history.found > 4 * history.frames;
        const bool mostlyLost = 5 * history.found < history.frames;
        result.mostlyTracked += mostlyTracked ? 1 : 0;
        result.mostlyLost += mostlyLost ? 1 : 0;
        result.partlyTracked += mostlyTracked || mostlyLost ? 0 : 1;
    }
    return result;
}

double distanceOf(const ScoredFrame& frame, const MatchedPair& pair)
{
    return (frame.truth[pair.truth].box.centre() - frame.tracks[pair.track].report.box.centre())
        .norm();
}
}  // namespace

ClearMot clearMot(const Sequence& sequence, const std::vector<FrameMatches>& matches)
{
    assert(matches.size() == sequence.frames.size());
    ClearMot result = countsOf(historiesOf(sequence, matches));
    double overlap = 0.0;
    double distance = 0.0;
    for (std::size_t f = 0; f < matches.size(); ++f)
    {
        result.falsePositives += matches[f].falseAlarms.size();
        for (const MatchedPair& pair : matches[f].pairs)
        {
            overlap += pair.overlap;
            distance += distanceOf(sequence.frames[f], pair);
        }
    }
    const auto tp = static_cast<double>(result.truePositives);
    const auto fp = static_cast<double>(result.falsePositives);
    const auto fn = static_cast<double>(result.falseNegatives);
    result.mota = share(tp - fp - static_cast<double>(result.identitySwitches), tp + fn);
    result.motp = share(overlap, tp);
    result.motpDistance = share(distance, tp);
    result.recall = share(tp, tp + fn);
    result.precision = share(tp, tp + fp);
    return result;
}

}  // namespace vdamf
