// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/shared_cut.h"

#include <utility>

namespace vdamf
{
SegmentedFrame withSharedClustersCut(SegmentedFrame frame,
                                     const std::vector<PredictedTarget>& targets,
                                     const TrackerOptions& options)
{
    for (const SharedCluster& shared : sharedClusters(targets, frame.hits, options.association))
    {
        std::vector<PredictedTarget> sharing;
        for (const std::size_t j : shared.targets) sharing.push_back(targets[j]);
        std::vector<Cluster> pieces =
            cutBetween(frame.clusters[shared.cluster], sharing, frame.hits[shared.cluster].time,
                       options.association);
        const bool isVehicle =
            shared.cluster < frame.isVehicle.size() && frame.isVehicle[shared.cluster];
        for (std::size_t k = 0; k < pieces.size(); ++k)
        {
            Hits hits = projected(pieces[k], options.measurement.mergeCell, frame.planar);
            if (k == 0)
            {
                frame.clusters[shared.cluster] = std::move(pieces[k]);
                frame.hits[shared.cluster] = std::move(hits);
                continue;
            }
            frame.isVehicle.resize(frame.clusters.size(), false);
            frame.isVehicle.push_back(isVehicle);
            frame.clusters.push_back(std::move(pieces[k]));
            frame.hits.push_back(std::move(hits));
        }
    }
    return frame;
}

}  // namespace vdamf
