// SPDX-License-Identifier: BSD-3-Clause
#include "trajectories.h"

#include "overlaps.h"

namespace vdamf
{
namespace
{
/// Gives a number to every identity, in order of appearance, and counts its frames.
template <class Id>
class Numbering
{
public:
    std::size_t add(const Id& id)
    {
        const std::size_t number = numbers_.try_emplace(id, numbers_.size()).first->second;
        lengths_.resize(numbers_.size(), 0);
        ++lengths_[number];
        return number;
    }
    const std::vector<std::size_t>& lengths() const { return lengths_; }

private:
    std::map<Id, std::size_t> numbers_;
    std::vector<std::size_t> lengths_;
};

std::vector<MatchedPair> overlapsAboveZero(const ScoredFrame& frame)
{
    std::vector<MatchedPair> pairs;
    const std::vector<std::vector<double>> overlaps = overlapsOf(frame);
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        for (std::size_t j = 0; j < frame.tracks.size(); ++j)
        {
            if (overlaps[i][j] > 0.0) pairs.push_back({i, j, overlaps[i][j]});
        }
    }
    return pairs;
}
}  // namespace

Trajectories trajectoriesOf(const Sequence& sequence)
{
    Trajectories result;
    Numbering<std::string> objects;
    Numbering<std::uint64_t> tracks;
    for (const ScoredFrame& frame : sequence.frames)
    {
        TrajectoryFrame& numbered = result.frames.emplace_back();
        for (const TruthRow& row : frame.truth)
        {
            numbered.objects.push_back(objects.add(row.objectId));
        }
        for (const TrackRow& row : frame.tracks)
        {
            numbered.tracks.push_back(tracks.add(row.report.id));
        }
        numbered.overlaps = overlapsAboveZero(frame);
        result.objectRows += frame.truth.size();
        result.trackRows += frame.tracks.size();
    }
    result.objectLengths = objects.lengths();
    result.trackLengths = tracks.lengths();
    return result;
}

}  // namespace vdamf
