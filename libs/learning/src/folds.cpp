// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/folds.h"

#include <algorithm>
#include <map>
#include <random>

namespace vdamf
{
namespace
{
struct Counts
{
    double vehicles = 0.0;
    double clutter = 0.0;
};

struct Group
{
    std::vector<std::size_t> tracks;
    Counts counts;
};

/// By falling size, those of one size in an order of the seed.
std::vector<Group> groupsOf(const std::vector<TrackSamples>& tracks, std::uint64_t seed)
{
    std::map<std::string, Group> byName;
    for (std::size_t i = 0; i < tracks.size(); ++i)
    {
        Group& group = byName[tracks[i].group];
        group.tracks.push_back(i);
        for (const ObjectSample& sample : tracks[i].frames)
        {
            group.counts.vehicles += sample.label == ObjectLabel::Vehicle ? 1.0 : 0.0;
            group.counts.clutter += sample.label == ObjectLabel::Clutter ? 1.0 : 0.0;
        }
    }
    std::vector<Group> groups;
    for (auto& [name, group] : byName) groups.push_back(std::move(group));
    std::mt19937_64 random(seed);
    for (std::size_t i = groups.size(); i > 1; --i) std::swap(groups[i - 1], groups[random() % i]);
    const auto size = [](const Group& g) { return g.counts.vehicles + g.counts.clutter; };
    std::stable_sort(groups.begin(), groups.end(),
                     [&](const Group& a, const Group& b) { return size(a) > size(b); });
    return groups;
}
}  // namespace

std::vector<int> foldsOf(const std::vector<TrackSamples>& tracks, int folds, std::uint64_t seed)
{
    const std::vector<Group> groups = groupsOf(tracks, seed);
    Counts all;
    for (const Group& group : groups)
    {
        all.vehicles += group.counts.vehicles;
        all.clutter += group.counts.clutter;
    }
    std::vector<int> foldOf(tracks.size(), 0);
    std::vector<Counts> filled(static_cast<std::size_t>(folds));
    for (const Group& group : groups)
    {
        const auto excess = [&](const Counts& fold)
        {
            const double v = (fold.vehicles + group.counts.vehicles) / std::max(1.0, all.vehicles);
            const double c = (fold.clutter + group.counts.clutter) / std::max(1.0, all.clutter);
            return v * v + c * c -
                   fold.vehicles * fold.vehicles / std::max(1.0, all.vehicles) /
                       std::max(1.0, all.vehicles) -
                   fold.clutter * fold.clutter / std::max(1.0, all.clutter) /
                       std::max(1.0, all.clutter);
        };
        const auto best = std::min_element(filled.begin(), filled.end(),
                                           [&](const Counts& a, const Counts& b)
                                           { return excess(a) < excess(b); });
        best->vehicles += group.counts.vehicles;
        best->clutter += group.counts.clutter;
        for (const std::size_t track : group.tracks)
            foldOf[track] = static_cast<int>(best - filled.begin());
    }
    return foldOf;
}

}  // namespace vdamf
