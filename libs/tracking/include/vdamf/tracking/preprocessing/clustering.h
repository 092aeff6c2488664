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
    template <class Self, class Visitor>
    static void visit(Self&, Visitor&&)
    {
    }
};

std::vector<Cluster> clusterPoints(const LadarFrame& frame, const AboveGround& aboveGround,
                                   const ClusterOptions& options);

}  // namespace vdamf
