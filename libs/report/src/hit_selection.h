// SPDX-License-Identifier: BSD-3-Clause
// Which hits of a frame a picture needs: all that lie on tracks, a few of everything else.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vdamf/tracking/preprocessing/clustering.h"
#include "vdamf/tracking/preprocessing/ground.h"
#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
using HitPositions = std::vector<Eigen::Vector3f>;  ///< world axes, relative to the frame's origin

struct ShownCluster
{
    std::uint64_t track = 0;  ///< the one most of its hits lie on; 0: none
    HitPositions hits;
};

/// The hits of one frame by what they lie on.
struct ShownHits
{
    HitPositions ground;
    HitPositions overhead;   ///< branches, bridges: above what is clustered
    HitPositions structure;  ///< above the ground, in no cluster: walls, and what is too small
    std::vector<ShownCluster> clusters;
    std::size_t aboveGround = 0;  ///< hits of the frame, before thinning
    std::size_t clusterCount = 0;
};

struct HitSelectionOptions
{
    GroundOptions ground;
    ClusterOptions clustering;
    std::size_t hitsPerFrame = 14000;  ///< at most
    double maxRange = 120.0;           ///< from the sensor, m
};

/// Ground removal and clustering as the tracker does them, then thinning: hits in one cell of a
/// grid count as one, and cells grow until the hits are few enough. Two thirds of the hits are for
/// clusters on tracks, a quarter of the rest for the ground. A cluster keeps some hits always.
ShownHits selectHits(const LadarFrame& frame, const FrameResult& result,
                     const HitSelectionOptions& options);

}  // namespace vdamf
