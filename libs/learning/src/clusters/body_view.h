// SPDX-License-Identifier: BSD-3-Clause
// Standing bodies as one sweep of a LADAR at the origin of the plane sees them.
#pragma once

#include <vector>

#include "vdamf/simulation/body.h"
#include "vdamf/simulation/random_stream.h"
#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
struct StandingBody
{
    Body body;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the body's origin, m
    double heading = 0.0;                                ///< rad
    double visibleTop = 0.0;                             ///< higher hits are left out, m
};

/// Hits, with the body that each lies on.
struct BodyView
{
    Cluster cluster;
    std::vector<std::size_t> body;

    std::size_t hitsOn(std::size_t which) const;
};

/// Nearest surfaces along the beams of an HDL-32E at 10 Hz around `target`, 1.7 to 2.1 m above the
/// ground; hits lower than 0.22 m or higher than 3 m over the ground are left out, as ground
/// removal does.
BodyView viewOf(const std::vector<StandingBody>& bodies, const OrientedBox& target,
                double rangeNoise, RandomStream& random);

/// Without what lies on one side of a bearing that hides 30 to 60 % of the bearings with hits.
BodyView partlyHidden(const BodyView& view, RandomStream& random);

}  // namespace vdamf
