// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/mistakes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace vdamf
{
namespace
{
/// Joins frames in a row to one mistake.
class Episodes
{
public:
    explicit Episodes(double longestBreak) : longestBreak_(longestBreak) {}

    /// `size`: the larger, the worse.
    Mistake& add(MistakeKind kind, const std::string& object, std::optional<std::uint64_t> track,
                 double time, double size)
    {
        const auto key = std::make_tuple(kind, object, track);
        const auto open = open_.find(key);
        const bool continues =
            open != open_.end() && time - all_[open->second].lastTime <= longestBreak_;
        if (!continues)
        {
            open_[key] = all_.size();
            all_.push_back({kind, object, track, std::nullopt, time, time, 0, size, time});
        }
        Mistake& mistake = all_[open_[key]];
        mistake.lastTime = time;
        ++mistake.frames;
        if (size > mistake.worst)
        {
            mistake.worst = size;
            mistake.worstTime = time;
        }
        return mistake;
    }

    std::vector<Mistake> byTime()
    {
        std::stable_sort(all_.begin(), all_.end(),
                         [](const Mistake& a, const Mistake& b)
                         { return a.firstTime < b.firstTime; });
        return std::move(all_);
    }

private:
    double longestBreak_;
    std::vector<Mistake> all_;
    std::map<std::tuple<MistakeKind, std::string, std::optional<std::uint64_t>>, std::size_t> open_;
};

/// Loose pairs of one time: the track on an object and how much of it overlaps.
using LoosePairs = std::map<std::pair<double, std::string>, const PoseError*>;

class Search
{
public:
    Search(const Sequence& sequence, const std::vector<FrameMatches>& matches,
           const std::vector<PoseError>& pairs, const MistakeOptions& options)
        : sequence_(sequence), matches_(matches), options_(options), episodes_(options.longestBreak)
    {
        for (const PoseError& pair : pairs) loose_[{pair.time, pair.objectId}] = &pair;
        for (std::size_t f = 0; f < matches.size(); ++f)
            for (const MatchedPair& pair : matches[f].pairs)
                everFound_.insert(sequence.frames[f].truth[pair.truth].objectId);
    }

    std::vector<Mistake> run()
    {
        for (std::size_t f = 0; f < matches_.size(); ++f)
        {
            takeFound(sequence_.frames[f], matches_[f]);
            takeMissed(sequence_.frames[f], matches_[f]);
            takeFalse(sequence_.frames[f], matches_[f]);
        }
        for (const auto& [key, pair] : loose_) takeErrors(*pair);
        std::vector<Mistake> all = episodes_.byTime();
        const auto isInTime = [this](const Mistake& m) {
            return m.kind == MistakeKind::FoundLate &&
                   m.lastTime - m.firstTime < options_.lateAfter;
        };
        all.erase(std::remove_if(all.begin(), all.end(), isInTime), all.end());
        for (Mistake& mistake : all)
            if (mistake.kind == MistakeKind::BoxOff) mistake.worst = 1.0 - mistake.worst;
        return all;
    }

private:
    void takeFound(const ScoredFrame& frame, const FrameMatches& matches)
    {
        for (const MatchedPair& pair : matches.pairs)
        {
            const std::string& object = frame.truth[pair.truth].objectId;
            const std::uint64_t track = frame.tracks[pair.track].report.id;
            const auto [last, isFirst] = lastTrack_.try_emplace(object, track);
            if (isFirst || last->second == track) continue;
            episodes_.add(MistakeKind::IdentitySwitch, object, track, frame.time, 0.0).trackBefore =
                last->second;
            last->second = track;
        }
    }

    void takeMissed(const ScoredFrame& frame, const FrameMatches& matches)
    {
        for (const std::size_t i : matches.missed)
        {
            const std::string& object = frame.truth[i].objectId;
            const auto loose = loose_.find({frame.time, object});
            if (loose != loose_.end())
                episodes_.add(MistakeKind::BoxOff, object, loose->second->trackId, frame.time,
                              1.0 - loose->second->overlap);
            else
                episodes_.add(kindOfMiss(object), object, std::nullopt, frame.time, 0.0);
        }
    }

    MistakeKind kindOfMiss(const std::string& object) const
    {
        if (everFound_.count(object) == 0) return MistakeKind::NeverFound;
        return lastTrack_.count(object) == 0 ? MistakeKind::FoundLate : MistakeKind::Lost;
    }

    void takeFalse(const ScoredFrame& frame, const FrameMatches& matches)
    {
        for (const std::size_t j : matches.falseAlarms)
        {
            const std::uint64_t track = frame.tracks[j].report.id;
            // A box that is off is told of once, with its object.
            const bool isOff = std::any_of(
                matches.missed.begin(), matches.missed.end(),
                [&](std::size_t i)
                {
                    const auto loose = loose_.find({frame.time, frame.truth[i].objectId});
                    return loose != loose_.end() && loose->second->trackId == track;
                });
            if (!isOff) episodes_.add(MistakeKind::FalseTrack, "", track, frame.time, 0.0);
        }
    }

    void takeErrors(const PoseError& pair)
    {
        const auto take = [&](MistakeKind kind, double error, double limit)
        {
            if (std::abs(error) > limit)
                episodes_.add(kind, pair.objectId, pair.trackId, pair.time, std::abs(error));
        };
        take(MistakeKind::Position, pair.position, options_.position);
        take(MistakeKind::Heading, pair.headingAxis, options_.heading);
        if (pair.flipped) take(MistakeKind::Flip, pair.heading, 0.0);
        take(MistakeKind::Speed, pair.speed, options_.speed);
        take(MistakeKind::Size, std::max(std::abs(pair.length), std::abs(pair.width)),
             options_.size);
    }

    const Sequence& sequence_;
    const std::vector<FrameMatches>& matches_;
    const MistakeOptions& options_;
    Episodes episodes_;
    LoosePairs loose_;
    std::set<std::string> everFound_;
    std::map<std::string, std::uint64_t> lastTrack_;
};
}  // namespace

const char* nameOf(MistakeKind kind)
{
    switch (kind)
    {
        case MistakeKind::NeverFound:
            return "never_found";
        case MistakeKind::FoundLate:
            return "found_late";
        case MistakeKind::Lost:
            return "lost";
        case MistakeKind::BoxOff:
            return "box_off";
        case MistakeKind::IdentitySwitch:
            return "identity_switch";
        case MistakeKind::FalseTrack:
            return "false_track";
        case MistakeKind::Position:
            return "position";
        case MistakeKind::Heading:
            return "heading";
        case MistakeKind::Flip:
            return "flip";
        case MistakeKind::Speed:
            return "speed";
        case MistakeKind::Size:
            return "size";
    }
    return "";
}

std::vector<Mistake> mistakesOf(const Sequence& sequence, const std::vector<FrameMatches>& matches,
                                const std::vector<PoseError>& pairs, const MistakeOptions& options)
{
    assert(matches.size() == sequence.frames.size());
    return Search(sequence, matches, pairs, options).run();
}

}  // namespace vdamf
