// SPDX-License-Identifier: BSD-3-Clause
// Fig. 2, "remove ground": which hits stand above the local ground, and how high.
#pragma once

#include <cstdint>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
struct GroundOptions
{
    // Members, visit(): with the implementation.
    template <class Self, class Visitor>
    static void visit(Self&, Visitor&&)
    {
    }
};

/// Hits above the ground, with their height over the ground below them.
struct AboveGround
{
    std::vector<std::uint32_t> index;  ///< of the hit in the frame's points
    std::vector<float> height;         ///< above local ground, m; same length
};

AboveGround removeGround(const LadarFrame& frame, const GroundOptions& options);

}  // namespace vdamf
