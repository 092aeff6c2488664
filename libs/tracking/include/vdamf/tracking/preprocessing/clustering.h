// SPDX-License-Identifier: BSD-3-Clause
// Fig. 2, "segment": hits above ground to clusters, each inside at most one target.
#pragma once

#include <vector>

#include "vdamf/tracking/preprocessing/ground.h"
#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
struct ClusterOptions
{
    double gap = 0.4;           ///< that joins two cells close to the sensor, m
    double gapPerRange = 0.01;  ///< growth of the gap with the range from the sensor, rad
    double maxGap = 0.8;      ///< at any range, m; vehicles keep 1 m from other objects (section 2)
    double maxExtent = 30.0;  ///< longer clusters (walls, facades) are dropped, m
    int minPoints = 5;        ///< smaller clusters are dropped

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.gap, "gap_m", 0.05, 2.0, "gap inside a cluster close to the sensor");
        field(self.gapPerRange, "gap_per_range_rad", 0.0, 0.1,
              "growth of the gap with the range: a few times the angle between hits");
        field(self.maxGap, "max_gap_m", 0.05, 2.0, "largest gap inside a cluster at any range");
        field(self.maxExtent, "max_extent_m", 5.0, 500.0,
              "longer clusters are dropped: walls, facades");
        field(self.minPoints, "min_points", 1, 1000, "clusters with fewer hits are dropped");
    }
};

/// All hits above ground.
struct ClusteredHits
{
    std::vector<Cluster> clusters;
    Cluster loose;  ///< in groups too small for a cluster
};

/// Groups of hits with no gap between them in the horizontal plane, ordered by their first cell
/// (south to north, then west to east); hits keep the order of the frame. On the safe side: an
/// object may come in several clusters, but two objects with 1 m between them do not share one.
ClusteredHits clusterHits(const LadarFrame& frame, const AboveGround& aboveGround,
                          const ClusterOptions& options);

/// The clusters alone.
std::vector<Cluster> clusterPoints(const LadarFrame& frame, const AboveGround& aboveGround,
                                   const ClusterOptions& options);

}  // namespace vdamf
