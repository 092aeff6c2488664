// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/clutter.h"

namespace vdamf
{
namespace
{
std::vector<std::size_t> clutterAmong(const std::vector<PredictedTarget>& targets)
{
    std::vector<std::size_t> clutter;
    for (std::size_t j = 0; j < targets.size(); ++j)
        if (targets[j].isClutter) clutter.push_back(j);
    return clutter;
}

std::vector<PlaneBounds> placesOf(const std::vector<PredictedTarget>& targets,
                                  const std::vector<std::size_t>& among)
{
    std::vector<PlaneBounds> places;
    places.reserve(among.size());
    for (const std::size_t j : among)
        places.push_back(PlaneBounds::around(targets[j].box.centre(), 0.0));
    return places;
}
}  // namespace

Clutter::Clutter(const std::vector<PredictedTarget>& targets)
    : targets_(clutterAmong(targets)), places_(placesOf(targets, targets_))
{
}

std::vector<std::size_t> Clutter::within(const ClusterBounds& cluster) const
{
    std::vector<std::size_t> found = places_.overlapping(PlaneBounds::around(cluster));
    for (std::size_t& j : found) j = targets_[j];
    return found;
}

}  // namespace vdamf
