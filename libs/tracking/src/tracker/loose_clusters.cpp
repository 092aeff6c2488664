// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/loose_clusters.h"

#include <utility>

#include "association/loose_hits.h"

namespace vdamf
{
std::vector<std::vector<std::size_t>> withLooseHits(
    std::vector<std::vector<std::size_t>> assignment, SegmentedFrame& frame,
    const std::vector<PredictedTarget>& targets, const TrackerOptions& options)
{
    std::vector<Cluster> found =
        looseHitsOn(targets, assignment, frame.loose, frame.sensor, options.association);
    for (std::size_t j = 0; j < found.size(); ++j)
    {
        if (found[j].size() == 0) continue;
        assignment[j].push_back(frame.clusters.size());
        frame.hits.push_back(projected(found[j], options.measurement.mergeCell, frame.planar));
        frame.clusters.push_back(std::move(found[j]));
    }
    return assignment;
}

}  // namespace vdamf
