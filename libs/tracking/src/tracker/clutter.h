// SPDX-License-Identifier: BSD-3-Clause
// Where tracks are that are surely no vehicles.
#pragma once

#include <cstddef>
#include <vector>

#include "association/plane_index.h"
#include "vdamf/tracking/association/auction.h"

namespace vdamf
{
class Clutter
{
public:
    explicit Clutter(const std::vector<PredictedTarget>& targets);

    /// Those targets whose places are within the cluster's bounds, rising.
    std::vector<std::size_t> within(const ClusterBounds& cluster) const;

private:
    std::vector<std::size_t> targets_;
    PlaneIndex places_;
};

}  // namespace vdamf
